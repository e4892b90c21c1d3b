#include "host/image/png_encode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <thread>

#include "host/image/png_chunks.hpp"
#include "host/image/png_pixel_hash.hpp"
#include "host/image/png_stripes.hpp"
#include "host/threads.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::array<std::uint8_t, 2> zlib_head{0x78, 0x01};         // deflate, a window of 32 KB, fast
constexpr std::array<std::uint8_t, 2> last_empty_block{0x03, 0x00};  // of the fixed codes: its end alone
constexpr std::size_t hash_digits = 32;
constexpr std::uint8_t png_rgb = 2, png_rgba = 6;  // colour types

int stripes_in(const FrameBuffer& frame) { return (frame.height() + png_stripe_lines - 1) / png_stripe_lines; }

// What one thread makes: stripes as they stand in a file, one IDAT chunk each.
struct StripeRun {
  std::vector<char> bytes;
  Adler32 checksum;
  std::exception_ptr failure;
};

// Kept by the thread: fresh memory costs more than the work in it.
PngStripes& stripes_of_this_thread(const FrameBuffer& frame, const PngPixels& pixels) {
  thread_local std::unique_ptr<PngStripes> stripes;
  if (!stripes) stripes = std::make_unique<PngStripes>();
  stripes->begin(frame, pixels);
  return *stripes;
}

// Appends the stripes first to last - 1. `hasher` may be null.
void append_stripes(StripeRun& run, const FrameBuffer& frame, const PngPixels& pixels, int first, int last,
                    PngPixelHasher* hasher) {
  PngStripes& stripes = stripes_of_this_thread(frame, pixels);
  for (int i = first; i < last; ++i) {
    const PngStripes::Stripe stripe = stripes.encode(i * png_stripe_lines);
    if (hasher) hasher->add(stripe.pixels);
    append_chunk(run.bytes, "IDAT", i == 0 ? std::span<const std::uint8_t>(zlib_head) : stripe.blocks,
                 i == 0 ? stripe.blocks : std::span<const std::uint8_t>{});
    run.checksum.append(stripe.checksum);
  }
}

// The same by further threads, while this one makes the hash, which goes through the pixels in their order.
std::vector<StripeRun> encode_stripes_with_threads(const FrameBuffer& frame, const PngPixels& pixels, int stripe_count,
                                                   int threads, PngPixelHasher& hasher) {
  std::vector<StripeRun> runs(static_cast<std::size_t>(threads));
  const auto encode_run = [&](int i) {
    StripeRun& run = runs[static_cast<std::size_t>(i)];
    try {
      append_stripes(run, frame, pixels, stripe_count * i / threads, stripe_count * (i + 1) / threads, nullptr);
    } catch (...) {
      run.failure = std::current_exception();
    }
  };
  std::vector<std::jthread> workers;
  const int started = start_threads(workers, threads, encode_run);
  PngStripes& stripes = stripes_of_this_thread(frame, pixels);
  for (int i = 0; i < stripe_count; ++i) hasher.add(stripes.convert(i * png_stripe_lines));
  for (int i = started; i < threads; ++i) encode_run(i);
  workers.clear();  // a jthread joins when it goes
  for (const StripeRun& run : runs)
    if (run.failure) std::rethrow_exception(run.failure);
  return runs;
}

bool is_printable_ascii(char c) { return c >= ' ' && c <= '~'; }

void append_texts(std::vector<char>& bytes, const FrameAttributes& attributes, const std::string& hash) {
  if (!std::all_of(attributes.fingerprint.begin(), attributes.fingerprint.end(), is_printable_ascii))
    throw Error(ErrorKind::usage, "", "a fingerprint of other characters than printable ASCII");
  append_text_chunk(bytes, frame_text, std::to_string(attributes.frame));
  append_text_chunk(bytes, fingerprint_text, attributes.fingerprint);
  if (!attributes.deviation.empty()) {
    std::string deviation = attributes.deviation;  // a device names itself as it likes
    std::replace_if(deviation.begin(), deviation.end(), std::not_fn(is_printable_ascii), '?');
    append_text_chunk(bytes, deviation_text, deviation);
  }
  append_text_chunk(bytes, pixel_hash_text, hash);
}

// Replaces `bytes` by what every file begins with.
void write_png_opening(std::vector<char>& bytes, const FrameBuffer& frame, int bits, std::uint8_t color_type) {
  constexpr std::uint8_t perceptual = 0;
  bytes.assign(png_signature.begin(), png_signature.end());
  const auto width = big_endian_bytes(static_cast<std::uint32_t>(frame.width()));
  const auto height = big_endian_bytes(static_cast<std::uint32_t>(frame.height()));
  std::array<std::uint8_t, 13> header{};  // its last three bytes are 0: deflate, the one set of filters, not interlaced
  std::copy(height.begin(), height.end(), std::copy(width.begin(), width.end(), header.begin()));
  header[8] = static_cast<std::uint8_t>(bits);
  header[9] = color_type;
  append_chunk(bytes, "IHDR", header);
  append_chunk(bytes, "sRGB", std::array<std::uint8_t, 1>{perceptual});
  append_chunk(bytes, "gAMA", std::array<std::uint8_t, 4>{0x00, 0x00, 0xb1, 0x8f});  // 45455: what goes with sRGB
}

// Replaces `bytes` by all that stands before the pixels.
void write_png_head(std::vector<char>& bytes, const FrameBuffer& frame, const FrameAttributes& attributes, int bits,
                    const std::string& hash) {
  write_png_opening(bytes, frame, bits, png_rgba);
  append_texts(bytes, attributes, hash);
}

void append_end(std::vector<char>& bytes, const Adler32& checksum) {
  append_chunk(bytes, "IDAT", last_empty_block, big_endian_bytes(checksum.value));
  append_chunk(bytes, "IEND", {});
}

}  // namespace

std::string encode_png(std::vector<char>& bytes, const FrameBuffer& frame, const FrameAttributes& attributes, int bits,
                       int threads, const Exposure& exposure) {
  check_png_bits(bits);
  if (!frame.has_color()) throw Error(ErrorKind::usage, "", "PNG of a frame without colour; ask for RGBA");
  write_png_head(bytes, frame, attributes, bits, std::string(hash_digits, '0'));  // the hash is not known yet
  const PngPixels pixels{.bits = bits, .exposure = exposure};
  const int stripe_count = stripes_in(frame);
  PngPixelHasher hasher(static_cast<std::uint32_t>(frame.width()), static_cast<std::uint32_t>(frame.height()), bits);
  StripeRun all;
  all.bytes.swap(bytes);
  if (threads > 1 && stripe_count > 1) {
    for (const StripeRun& run :
         encode_stripes_with_threads(frame, pixels, stripe_count, std::min(threads, stripe_count), hasher)) {
      all.bytes.insert(all.bytes.end(), run.bytes.begin(), run.bytes.end());
      all.checksum.append(run.checksum);
    }
  } else {
    append_stripes(all, frame, pixels, 0, stripe_count, &hasher);
  }
  bytes.swap(all.bytes);
  append_end(bytes, all.checksum);
  const std::string hash = hasher.hex();
  std::vector<char> head;
  write_png_head(head, frame, attributes, bits, hash);
  std::copy(head.begin(), head.end(), bytes.begin());
  return hash;
}

void encode_png_over(std::vector<char>& bytes, const FrameBuffer& frame, Rgb background, const Exposure& exposure) {
  if (!frame.has_color()) throw Error(ErrorKind::usage, "", "a picture of a frame without colour; ask for RGBA");
  const PngPixels pixels{.exposure = exposure, .background = background};
  StripeRun all;
  all.bytes.swap(bytes);
  write_png_opening(all.bytes, frame, pixels.bits, png_rgb);
  append_stripes(all, frame, pixels, 0, stripes_in(frame), nullptr);
  bytes.swap(all.bytes);
  append_end(bytes, all.checksum);
}

std::string relabel_png(std::vector<char>& bytes, std::span<const char> source, const FrameAttributes& attributes) {
  constexpr std::size_t around_data = 12;  // length, type, CRC
  bytes.assign(source.begin(),
               source.begin() + static_cast<std::ptrdiff_t>(std::min(source.size(), png_signature.size())));
  std::string hash;
  for (std::size_t at = png_signature.size(); at + around_data <= source.size();) {
    const std::size_t length = big_endian(source.data() + at) + around_data;
    const std::string_view type(source.data() + at + 4, 4);
    if (length > source.size() - at) break;
    const std::string_view data(source.data() + at + 8, length - around_data);
    if (type == "IDAT" && hash.size() == hash_digits) {
      append_texts(bytes, attributes, hash);
      bytes.insert(bytes.end(), source.begin() + static_cast<std::ptrdiff_t>(at), source.end());
      return hash;
    }
    if (type != "tEXt")
      bytes.insert(bytes.end(), source.begin() + static_cast<std::ptrdiff_t>(at),
                   source.begin() + static_cast<std::ptrdiff_t>(at + length));
    else if (data.starts_with(pixel_hash_text))
      hash = data.substr(std::min(data.size(), pixel_hash_text.size() + 1));
    at += length;
  }
  throw Error(ErrorKind::internal, "", "is no file that this library made");
}

}  // namespace morphcl
