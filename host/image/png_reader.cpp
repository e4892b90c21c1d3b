#include "host/image/png_reader.hpp"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <new>
#include <string_view>

#include "host/image/png_chunks.hpp"
#include "host/image/png_lines.hpp"
#include "host/image/png_pixel_hash.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t piece_bytes = 65536;  // that are read at once
// Deflate spends at least one bit on 129 bytes.
constexpr double largest_expansion = 1032;

[[noreturn]] void refuse_png(const std::string& message) { throw Error(ErrorKind::bad_input, "", message); }

struct PngColor {
  std::uint8_t type;
  std::string_view name;
  int samples;
  std::string_view bits;  // that go with it, one character each: the logarithm of their number
};
constexpr std::array<PngColor, 5> png_colors{{{0, "grey", 1, "01234"},
                                              {2, "RGB", 3, "34"},
                                              {3, "palette", 1, "0123"},
                                              {4, "grey and alpha", 2, "34"},
                                              {6, "RGBA", 4, "34"}}};

// Latin-1, as texts of PNG are, in UTF-8.
std::string utf8_of_latin1(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xc0 | code >> 6);
      out += static_cast<char>(0x80 | (code & 0x3f));
    }
  }
  return out;
}

std::string text_of_key(const PngDescription& picture, std::string_view key) {
  const auto found =
      std::find_if(picture.texts.begin(), picture.texts.end(), [key](const PngText& text) { return text.key == key; });
  return found == picture.texts.end() ? std::string() : found->value;
}

class PngFile {
 public:
  PngFile(SizedInput& input, const PngVisitor& visitor) : input_(input), visitor_(visitor) {}

  PngDescription read() {
    std::array<char, png_signature.size()> signature{};
    if (input_.size() >= signature.size()) input_.read(signature.data(), static_cast<int>(signature.size()));
    if (!std::equal(signature.begin(), signature.end(), png_signature.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }))
      refuse_png("is not a PNG file");
    bool first = true, ended = false, enough = false;
    for (; !ended && !enough; first = false) {
      start_chunk();
      if (first != (type_ == "IHDR")) refuse_png("the header, IHDR, does not stand at its beginning alone");
      if (first) {
        read_header();
      } else if (type_ == "IDAT") {
        enough = !read_pixels();
      } else if (type_ == "tEXt") {
        read_text();
      } else {
        skip_data();
      }
      if (!enough) check_crc();
      ended = type_ == "IEND";
    }
    if (!enough) finish();
    return std::move(picture_);
  }

 private:
  std::uint64_t left() const { return input_.size() - input_.tellg(); }

  std::uint32_t number() {
    if (left() < 4) refuse_png("the file ends before its end chunk, IEND");
    std::array<char, 4> bytes{};
    input_.read(bytes.data(), static_cast<int>(bytes.size()));
    return big_endian(bytes.data());
  }

  // Length and type; the data has not been read.
  void start_chunk() {
    length_ = number();
    const std::uint32_t type = number();
    type_.clear();
    for (int shift = 24; shift >= 0; shift -= 8) type_ += static_cast<char>(type >> shift & 0xff);
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (!std::all_of(type_.begin(), type_.end(), letter)) refuse_png("a chunk's type is not four letters");
    if (length_ > png_longest_chunk || length_ + 4 > left())
      refuse_png(fmt::format("the chunk {} of {} bytes is longer than the file", type_, length_));
    crc_ = libdeflate_crc32(0, type_.data(), type_.size());
    unread_ = length_;
  }

  // The next bytes of the chunk's data, at most piece_bytes; none at its end.
  std::span<const std::uint8_t> piece() {
    const std::size_t count = std::min<std::size_t>(unread_, piece_bytes);
    if (buffer_.size() < count) buffer_.resize(count);
    input_.read(buffer_.data(), static_cast<int>(count));
    crc_ = libdeflate_crc32(crc_, buffer_.data(), count);
    unread_ -= count;
    return {reinterpret_cast<const std::uint8_t*>(buffer_.data()), count};
  }

  void skip_data() {
    while (unread_ > 0) piece();
  }

  void check_crc() {
    if (number() != crc_) refuse_png(fmt::format("the chunk {} is damaged: its CRC is another one", type_));
  }

  void read_header() {
    constexpr std::size_t header_bytes = 13;
    if (length_ != header_bytes) refuse_png(fmt::format("a header, IHDR, of {} bytes; it has 13", length_));
    const std::span<const std::uint8_t> data = piece();
    const auto* const numbers = reinterpret_cast<const char*>(data.data());
    picture_.width = big_endian(numbers);
    picture_.height = big_endian(numbers + 4);
    picture_.bits = data[8];
    const auto* const color = std::find_if(png_colors.begin(), png_colors.end(),
                                           [&data](const PngColor& known) { return known.type == data[9]; });
    constexpr std::int64_t longest_side = 0x7fffffff;
    if (picture_.width < 1 || picture_.height < 1 || picture_.width > longest_side || picture_.height > longest_side)
      refuse_png(fmt::format("a picture of {} x {} pixels; 1 to {} a side are possible", picture_.width,
                             picture_.height, longest_side));
    const auto goes_with = [&](char log) { return picture_.bits == 1 << (log - '0'); };
    if (color == png_colors.end() || !std::any_of(color->bits.begin(), color->bits.end(), goes_with))
      refuse_png(fmt::format("the colour type {} with {} bits is none", data[9], data[8]));
    if (data[10] != 0 || data[11] != 0 || data[12] > 1)
      refuse_png("a compression, filter or interlacing that PNG does not have");
    picture_.color = color->name;
    picture_.interlaced = data[12] == 1;
    check_claim(color->samples);
  }

  // Before memory is taken or time spent for the pixels.
  void check_claim(int samples) const {
    const double bytes =
        static_cast<double>(picture_.width) * static_cast<double>(picture_.height) * (picture_.bits * samples / 8.0);
    if (bytes > static_cast<double>(input_.size()) * largest_expansion)
      refuse_png(fmt::format("{} x {} pixels are more than a file of {} bytes can hold", picture_.width,
                             picture_.height, input_.size()));
  }

  void read_text() {
    std::string data;
    while (unread_ > 0) {
      const std::span<const std::uint8_t> bytes = piece();
      data.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    const std::size_t end_of_key = data.find('\0');
    if (end_of_key == std::string::npos) refuse_png("a text chunk, tEXt, without a key");
    picture_.texts.push_back({utf8_of_latin1(std::string_view(data).substr(0, end_of_key)),
                              utf8_of_latin1(std::string_view(data).substr(end_of_key + 1))});
  }

  // What the texts say about the frame.
  void read_attributes() {
    const std::string number = text_of_key(picture_, frame_text);
    std::int64_t frame = 0;
    if (std::from_chars(number.data(), number.data() + number.size(), frame).ec == std::errc())
      picture_.attributes.frame = frame;
    picture_.attributes.fingerprint = text_of_key(picture_, fingerprint_text);
    picture_.attributes.deviation = text_of_key(picture_, deviation_text);
    picture_.stored_hash = text_of_key(picture_, pixel_hash_text);
  }

  // Of one IDAT chunk. False: the visitor has enough.
  bool read_pixels() {
    if (!has_pixels_) {
      has_pixels_ = true;
      read_attributes();
      if (visitor_.begin && !visitor_.begin(picture_)) return false;
      if (are_straight(picture_)) start_lines();
    }
    while (unread_ > 0) {
      const std::span<const std::uint8_t> bytes = piece();
      if (lines_) lines_->add(bytes);
    }
    return true;
  }

  void start_lines() {
    const std::size_t pixel_bytes = static_cast<std::size_t>(picture_.bits) / 2;
    hasher_ = std::make_unique<PngPixelHasher>(static_cast<std::uint32_t>(picture_.width),
                                               static_cast<std::uint32_t>(picture_.height), picture_.bits);
    lines_ = std::make_unique<PngLines>(picture_.height, static_cast<std::size_t>(picture_.width) * pixel_bytes,
                                        pixel_bytes, [this](int y, std::span<const std::uint8_t> line) {
                                          hasher_->add(line);
                                          if (visitor_.line) visitor_.line(y, line);
                                        });
  }

  void finish() {
    if (!has_pixels_) refuse_png("has no pixels, no IDAT chunk");
    read_attributes();  // texts may stand behind the pixels
    if (!lines_) return;
    lines_->finish();
    picture_.hash = hasher_->hex();
  }

  SizedInput& input_;
  const PngVisitor& visitor_;
  PngDescription picture_;
  std::uint64_t length_ = 0, unread_ = 0;  // of the chunk's data
  std::string type_;
  std::uint32_t crc_ = 0;
  std::vector<char> buffer_;
  bool has_pixels_ = false;
  std::unique_ptr<PngPixelHasher> hasher_;
  std::unique_ptr<PngLines> lines_;
};

}  // namespace

bool are_straight(const PngDescription& picture) {
  return picture.color == "RGBA" && !picture.interlaced &&
         std::max(picture.width, picture.height) <= FrameBuffer::max_side;
}

PngDescription read_png_file(SizedInput& input, const PngVisitor& visitor) {
  try {
    input.seekg(0);
    return PngFile(input, visitor).read();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {  // of the stream: the file became shorter
    throw Error(ErrorKind::bad_input, "", error.what());
  }
}

}  // namespace morphcl
