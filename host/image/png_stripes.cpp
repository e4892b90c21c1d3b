#include "host/image/png_stripes.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <cstring>

#include "host/image/straight_pixels.hpp"

namespace morphcl {

namespace {

static_assert(png_stripe_lines == FrameBuffer::block_side, "a stripe is a row of blocks");

constexpr std::uint8_t difference_from_above = 2;  // of PNG's filters: the cheapest that helps

}  // namespace

// Adler-32 is two sums modulo 65521: of the bytes, starting at 1, and of the first sum after each byte.
void Adler32::append(const Adler32& next) {
  constexpr std::uint64_t modulus = 65521;
  const std::uint64_t a = value & 0xffff, b = value >> 16, next_a = next.value & 0xffff, next_b = next.value >> 16;
  const std::uint64_t sum = (a + next_a + modulus - 1) % modulus;
  const std::uint64_t sums = (b + next_b + next.bytes % modulus * (a + modulus - 1)) % modulus;
  value = static_cast<std::uint32_t>(sums << 16 | sum);
  bytes += next.bytes;
}

void PngStripes::begin(const FrameBuffer& frame, const PngPixels& pixels) {
  frame_ = &frame;
  bits_ = pixels.bits;
  exposure_ = pixels.exposure;
  if (pixels.background)
    over_.emplace(*pixels.background, exposure_);
  else
    over_.reset();
  line_bytes_ = static_cast<std::size_t>(frame.width()) * (over_ ? 3 : straight_pixel_bytes(bits_));
  const auto lines = static_cast<std::size_t>(std::min(frame.height(), png_stripe_lines));
  pixels_.assign(line_bytes_ * (lines + 1), 0);
  for (auto* buffer : {&filtered_, &filtered_before_}) buffer->resize((line_bytes_ + 1) * lines);
  next_line_ = 0;
  is_blank_ = !over_;  // zeros are no background's colour
  lines_before_ = zero_lines_before_ = 0;
}

int PngStripes::lines_of(int first_line) const { return std::min(png_stripe_lines, frame_->height() - first_line); }

// With the spans of its row of blocks.
void PngStripes::write_line(int y, std::uint8_t* out) const {
  if (over_)
    over_->write(*frame_, spans_, y, 3, out);
  else
    write_straight_pixels(*frame_, spans_, y, bits_, exposure_, out);
}

// Above the first line are zeros.
void PngStripes::fetch_line_above(int first_line) {
  if (first_line == 0) {
    std::memset(pixels_.data(), 0, line_bytes_);
  } else if (first_line == next_line_) {
    std::memcpy(pixels_.data(), stripe() + (png_stripe_lines - 1) * line_bytes_, line_bytes_);
  } else {
    find_spans(spans_, *frame_, (first_line - 1) / png_stripe_lines);
    write_line(first_line - 1, pixels_.data());
  }
}

std::span<const std::uint8_t> PngStripes::convert(int first_line) {
  const int lines = lines_of(first_line);
  find_spans(spans_, *frame_, first_line / png_stripe_lines);
  const bool blank = std::all_of(spans_.begin(), spans_.end(), [](const PixelSpan& span) { return span.blank; });
  const bool stands_there = blank && is_blank_;
  for (int i = 0; i < lines && !stands_there; ++i)
    write_line(first_line + i, stripe() + static_cast<std::size_t>(i) * line_bytes_);
  is_blank_ = blank;
  next_line_ = first_line + lines;
  return {stripe(), static_cast<std::size_t>(lines) * line_bytes_};
}

void PngStripes::filter(int lines) {
  const std::size_t bytes =
      line_bytes_;  // not the member: bytes that are written could change it, for all the compiler knows
  for (std::size_t i = 0; i < static_cast<std::size_t>(lines); ++i) {
    std::uint8_t* const out = filtered_.data() + i * (bytes + 1);
    const std::uint8_t* const above = pixels_.data() + i * bytes;
    const std::uint8_t* const line = above + bytes;
    out[0] = difference_from_above;
    for (std::size_t x = 0; x < bytes; ++x) out[x + 1] = static_cast<std::uint8_t>(line[x] - above[x]);
  }
}

PngStripes::Stripe PngStripes::encode(int first_line) {
  const bool blank_above = first_line == 0 ? !over_ : first_line == next_line_ && is_blank_;
  fetch_line_above(first_line);
  const std::span<const std::uint8_t> pixels = convert(first_line);
  const int lines = lines_of(first_line);
  const auto line_count = static_cast<std::size_t>(lines);
  const bool zero = blank_above && is_blank_;  // filtered
  if (zero && zero_lines_before_ == line_count) return {pixels, blocks_, checksum_};

  filter(lines);
  const std::size_t bytes = line_count * (line_bytes_ + 1);
  if (lines_before_ != line_count || std::memcmp(filtered_.data(), filtered_before_.data(), bytes) != 0) {
    deflate_->encode({filtered_.data(), bytes}, blocks_);
    checksum_ = {libdeflate_adler32(1, filtered_.data(), bytes), bytes};
    filtered_.swap(filtered_before_);
  }
  lines_before_ = line_count;
  zero_lines_before_ = zero ? line_count : 0;
  return {pixels, blocks_, checksum_};
}

}  // namespace morphcl
