// The pixels of a PNG file, 16 lines at a time: converted, filtered, deflated.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "host/image/blank_spans.hpp"
#include "host/image/exposure.hpp"
#include "host/image/pixels_over.hpp"
#include "host/image/zlib_encoder.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

inline constexpr int png_stripe_lines = 16;

// Adler-32 (RFC 1950), of pieces that are put together.
struct Adler32 {
  std::uint32_t value = 1;
  std::uint64_t bytes = 0;
  void append(const Adler32& next);
};

// What the pixels of a file are: R, G, B, A of `bits` (8 or 16) each with straight alpha, or, over a background, R, G,
// B of 8 bits.
struct PngPixels {
  int bits = 8;
  Exposure exposure = Exposure();
  std::optional<Rgb> background = std::nullopt;
};

// Keeps its memory from frame to frame; for one thread at a time.
class PngStripes {
 public:
  struct Stripe {
    std::span<const std::uint8_t> pixels;  // unfiltered, without gaps
    std::span<const std::uint8_t> blocks;  // of DeflatePieces, for the filtered lines
    Adler32 checksum;                      // of the filtered lines
  };

  // encode() is about this frame now.
  void begin(const FrameBuffer& frame, const PngPixels& pixels);
  // The stripe whose first line is `first_line`, a multiple of 16; it stays until the next call. In order they cost
  // least: one with the same lines as the one before costs a comparison, one whose blocks are known to be blank, like
  // the two before, costs nothing.
  Stripe encode(int first_line);
  // Its pixels alone.
  std::span<const std::uint8_t> convert(int first_line);

 private:
  int lines_of(int first_line) const;
  void write_line(int y, std::uint8_t* out) const;
  std::uint8_t* stripe() { return pixels_.data() + line_bytes_; }
  void fetch_line_above(int first_line);
  void filter(int lines);

  const std::unique_ptr<DeflatePieces> deflate_ = make_deflate_pieces();
  const FrameBuffer* frame_ = nullptr;
  int bits_ = 8;
  Exposure exposure_;
  std::optional<PixelsOver> over_;
  std::size_t line_bytes_ = 0;
  std::vector<PixelSpan> spans_;
  std::vector<std::uint8_t> pixels_;  // of the line above the stripe, and of the stripe
  int next_line_ = 0;                 // the one below the stripe
  bool is_blank_ = false;             // every pixel of the stripe
  std::vector<std::uint8_t> filtered_, blocks_;
  Adler32 checksum_;                                      // of the lines that blocks_ holds
  std::vector<std::uint8_t> filtered_before_ = {};        // those lines
  std::size_t lines_before_ = 0, zero_lines_before_ = 0;  // how many; how many if all are zero
};

}  // namespace morphcl
