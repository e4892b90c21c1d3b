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
#include <type_traits>
#include <vector>

#include "host/image/blank_spans.hpp"

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

void PixelHasher::begin_channel(std::string_view name, Type type, const Window& window) {
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

constexpr std::size_t run_pixels = 16384;

template <class T>
const std::array<T, run_pixels>& blank_run() {
  static const std::array<T, run_pixels> run = [] {
    std::array<T, run_pixels> pixels{};
    if constexpr (std::is_same_v<T, float>) pixels.fill(background_depth);
    return pixels;
  }();
  return run;
}

// The pixels of a channel, the blank ones in as few pieces as can be: with each the hash moves some hundred bytes to
// and from a buffer of its own.
template <class T>
class RowHasher {
 public:
  explicit RowHasher(PixelHasher& hasher) : hasher_(hasher) {}
  void add(std::span<const T> row, const PixelSpan& span) {
    if (span.blank) {
      blank_ += span.count;
      return;
    }
    finish();
    hasher_.add_row(row.data() + span.first, span.count * sizeof(T));
  }
  void finish() {
    for (; blank_ > 0; blank_ -= std::min(blank_, run_pixels))
      hasher_.add_row(blank_run<T>().data(), std::min(blank_, run_pixels) * sizeof(T));
  }

 private:
  PixelHasher& hasher_;
  std::size_t blank_ = 0;  // pixels, not added yet
};

}  // namespace

std::string pixel_hash(const FrameBuffer& frame) {
  PixelHasher hasher;
  std::vector<PixelSpan> spans;
  const PixelHasher::Window window{0, 0, frame.width() - 1, frame.height() - 1};
  // row_of: a row's pixels in one channel.
  const auto add_channel = [&](std::string_view name, PixelHasher::Type type, const auto& row_of) {
    hasher.begin_channel(name, type, window);
    constexpr int side = FrameBuffer::block_side;
    RowHasher<std::remove_cvref_t<decltype(row_of(0)[0])>> rows(hasher);
    for (int y = 0; y < frame.height(); ++y) {
      if (y % side == 0) find_spans(spans, frame, y / side);
      const auto row = row_of(y);
      for (const PixelSpan& span : spans) rows.add(row, span);
    }
    rows.finish();
  };
  if (frame.has_color()) {
    constexpr std::array<std::string_view, 4> names{"A", "B", "G", "R"};
    constexpr std::array<int, 4> channels{3, 2, 1, 0};
    for (std::size_t i = 0; i < names.size(); ++i)
      add_channel(names[i], PixelHasher::Type::half, [&](int y) { return frame.color_row(channels[i], y); });
  }
  if (frame.has_depth()) add_channel("Z", PixelHasher::Type::float_, [&](int y) { return frame.depth_row(y); });
  return hasher.hex();
}

std::string text_hash(std::string_view text) { return hex_digits(XXH3_128bits(text.data(), text.size())); }

}  // namespace morphcl
