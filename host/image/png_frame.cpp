#include <fmt/format.h>
#include <half.h>

#include <array>
#include <memory>

#include "host/image/atomic_file.hpp"
#include "host/image/png_encode.hpp"
#include "host/image/png_reader.hpp"
#include "host/image/srgb.hpp"
#include "host/image/straight_pixels.hpp"
#include "host/image/written_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

const std::array<float, 65536>& linear_from_code() {
  static const auto table = [] {
    auto values = std::make_unique<std::array<float, 65536>>();
    for (std::size_t code = 0; code < values->size(); ++code)
      (*values)[code] = static_cast<float>(linear_from_srgb16(static_cast<std::uint16_t>(code)));
    return values;
  }();
  return *table;
}

// The sample `i` of a line, of 16 bits.
std::uint16_t sample_of(std::span<const std::uint8_t> line, std::size_t i, int bits) {
  return static_cast<std::uint16_t>(bits == 8 ? line[i] * 257 : line[2 * i] << 8 | line[2 * i + 1]);
}

// Lets memory alone that is 0 already.
void set_line(FrameBuffer& frame, int y, std::span<const std::uint8_t> line, int bits) {
  const std::array<float, 65536>& linear = linear_from_code();
  const std::array<std::span<std::uint16_t>, 4> rows{frame.color_row(0, y), frame.color_row(1, y),
                                                     frame.color_row(2, y), frame.color_row(3, y)};
  for (std::size_t x = 0; x < rows[3].size(); ++x) {
    const std::uint16_t alpha_sample = sample_of(line, 4 * x + 3, bits);
    if (alpha_sample == 0) continue;
    const float alpha = static_cast<float>(alpha_sample) / 65535;
    for (std::size_t channel = 0; channel < 3; ++channel)
      rows[channel][x] = half(linear[sample_of(line, 4 * x + channel, bits)] * alpha).bits();
    rows[3][x] = half(alpha).bits();
  }
}

PngFrame read_png_frame(SizedInput& input) {
  std::unique_ptr<FrameBuffer> frame;
  PngVisitor visitor;
  visitor.begin = [&frame](const PngDescription& picture) {
    if (!are_straight(picture))
      throw Error(ErrorKind::bad_input, "",
                  fmt::format("a PNG of {} with {} bits a sample{}, {} x {} pixels; RGBA with 8 or 16 bits, not "
                              "interlaced, up to {} pixels a side can be read",
                              picture.color, picture.bits, picture.interlaced ? ", interlaced" : "", picture.width,
                              picture.height, FrameBuffer::max_side));
    frame = std::make_unique<FrameBuffer>(static_cast<int>(picture.width), static_cast<int>(picture.height),
                                          ChannelSet{Channel::color});
    return true;
  };
  visitor.line = [&frame](int y, std::span<const std::uint8_t> line) {
    const std::size_t pixel_bytes = line.size() / static_cast<std::size_t>(frame->width());
    set_line(*frame, y, line, pixel_bytes == straight_pixel_bytes(8) ? 8 : 16);
  };
  PngDescription description = read_png_file(input, visitor);
  return {std::move(*frame), std::move(description)};
}

}  // namespace

void check_png_bits(int bits) {
  if (bits != 8 && bits != 16)
    throw Error(ErrorKind::usage, "", fmt::format("PNG frames of {} bits a sample; 8 or 16 are possible", bits));
}

std::string write_png(const std::string& path, const FrameBuffer& frame, const FrameAttributes& attributes, int bits,
                      int threads) {
  thread_local std::vector<char> bytes;  // kept from frame to frame
  try {
    const std::string hash = encode_png(bytes, frame, attributes, bits, threads);
    write_file_atomically(path, bytes);
    return hash;
  } catch (const Error& error) {
    throw error.at(path);
  }
}

PngDescription describe_png(const std::string& path) {
  try {
    FileInput input(path);
    return read_png_file(input);
  } catch (const Error& error) {
    throw error.at(path);
  }
}

PngFrame decode_png(std::span<const char> bytes) {
  MemoryInput input(bytes);
  return read_png_frame(input);
}

PngFrame read_png(const std::string& path) {
  try {
    FileInput input(path);
    return read_png_frame(input);
  } catch (const Error& error) {
    throw error.at(path);
  }
}

void verify_png(const std::string& path, const std::string& hash) {
  std::string found;
  try {
    const PngDescription picture = describe_png(path);
    found = picture.stored_hash == hash ? picture.hash : picture.stored_hash;
  } catch (const Error& error) {
    found = error.message();
  }
  require_read_back(path, hash, found);
}

std::optional<PngDescription> finished_png(const std::string& path, const std::string& fingerprint, int bits) {
  try {
    FileInput input(path);
    PngVisitor visitor;
    visitor.begin = [&](const PngDescription& picture) {  // the cheap questions first
      return picture.attributes.fingerprint == fingerprint && picture.bits == bits && are_straight(picture);
    };
    PngDescription picture = read_png_file(input, visitor);
    if (picture.stored_hash.empty() || picture.stored_hash != picture.hash) return std::nullopt;
    return picture;
  } catch (...) {
    return std::nullopt;
  }
}

}  // namespace morphcl
