#include "host/image/pixel_hash.hpp"

#include <fmt/format.h>
#if defined(__x86_64__)
#include <xxh_x86dispatch.h>  // the same functions, for the widest vectors that the processor has
#else
#include <xxhash.h>
#endif

#include <algorithm>
#include <bit>
#include <new>
#include <vector>

#include "host/image/blank_spans.hpp"
#include "host/image/channel_planes.hpp"

namespace morphcl {

static_assert(std::endian::native == std::endian::little, "the hash is defined over little-endian values");

namespace {

std::string hex_digits(const XXH128_hash_t& hash) { return fmt::format("{:016x}{:016x}", hash.high64, hash.low64); }

}  // namespace

struct PixelHasher::State {
  XXH3_state_t* xxh = XXH3_createState();
  ~State() { XXH3_freeState(xxh); }
};

PixelHasher::PixelHasher() : state_(std::make_unique<State>()) {
  if (state_->xxh == nullptr) throw std::bad_alloc();
  XXH3_128bits_reset(state_->xxh);
}

PixelHasher::~PixelHasher() = default;

void PixelHasher::begin_channel(std::string_view name, PixelType type, const Window& window) {
  XXH3_128bits_update(state_->xxh, name.data(), name.size());
  const char end_of_name = 0;
  XXH3_128bits_update(state_->xxh, &end_of_name, 1);
  const std::array<std::int32_t, 5> shape{static_cast<std::int32_t>(type), window.first_x, window.first_y,
                                          window.last_x, window.last_y};
  XXH3_128bits_update(state_->xxh, shape.data(), sizeof shape);
}

void PixelHasher::add_row(const void* values, std::size_t bytes) { XXH3_128bits_update(state_->xxh, values, bytes); }

std::string PixelHasher::hex() const { return hex_digits(XXH3_128bits_digest(state_->xxh)); }

namespace {

// Blank pixels that are hashed at once.
constexpr std::size_t run_pixels = 16384;

const std::array<std::uint32_t, run_pixels>& blank_run(Channel channel) {
  static const auto zeros = std::make_unique<std::array<std::uint32_t, run_pixels>>();
  static const auto distances = [] {
    auto run = std::make_unique<std::array<std::uint32_t, run_pixels>>();
    run->fill(background_bits(Channel::depth));
    return run;
  }();
  return background_bits(channel) == 0 ? *zeros : *distances;
}

// The pixels of a plane, the blank ones in as few pieces as can be: with each the hash moves some hundred bytes to and
// from a buffer of its own.
class RowHasher {
 public:
  RowHasher(PixelHasher& hasher, Channel channel)
      : hasher_(hasher), blank_run_(blank_run(channel).data()), element_bytes_(bytes_of(plane_type(channel))) {}
  void add(std::span<const std::byte> row, const PixelSpan& span) {
    if (span.blank) {
      blank_ += span.count;
      return;
    }
    finish();
    hasher_.add_row(row.data() + span.first * element_bytes_, span.count * element_bytes_);
  }
  void finish() {
    for (; blank_ > 0; blank_ -= std::min(blank_, run_pixels))
      hasher_.add_row(blank_run_, std::min(blank_, run_pixels) * element_bytes_);
  }

 private:
  PixelHasher& hasher_;
  const std::uint32_t* const blank_run_;
  const std::size_t element_bytes_;
  std::size_t blank_ = 0;  // pixels, not added yet
};

}  // namespace

std::string pixel_hash(const FrameBuffer& frame) {
  PixelHasher hasher;
  std::vector<PixelSpan> spans;
  const PixelHasher::Window window{0, 0, frame.width() - 1, frame.height() - 1};
  constexpr int side = FrameBuffer::block_side;
  for (const NamedPlane& plane : named_planes(frame.channels(), ChannelNames::plain)) {
    hasher.begin_channel(plane.name, plane_type(plane.channel), window);
    RowHasher rows(hasher, plane.channel);
    for (int y = 0; y < frame.height(); ++y) {
      if (y % side == 0) find_spans(spans, frame, y / side);
      const std::span<const std::byte> row = frame.plane_row(plane.channel, plane.plane, y);
      for (const PixelSpan& span : spans) rows.add(row, span);
    }
    rows.finish();
  }
  return hasher.hex();
}

std::string text_hash(std::string_view text) { return hex_digits(XXH3_128bits(text.data(), text.size())); }

}  // namespace morphcl
