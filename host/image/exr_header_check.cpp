#include "host/image/exr_header_check.hpp"

#include <ImfCompression.h>
#include <ImfPixelType.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "host/image/channel_planes.hpp"
#include "host/image/exr_compression.hpp"
#include "morphcl/error.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

namespace {

constexpr std::uint32_t magic_number = 20000630;
constexpr std::uint32_t tiled_flag = 0x200, deep_flag = 0x800, multipart_flag = 0x1000;
constexpr std::size_t longest_name = 255;
constexpr int max_channels = 1024;
constexpr std::uint64_t table_entry_bytes = 8;

// The types whose values OpenEXR reads without a look at the attribute's size; after another one it would go on at a
// place where no attribute begins, and take what stands there for sizes.
struct FixedType {
  std::string_view name;
  int bytes;
};
constexpr std::array<FixedType, 24> fixed_types{{{"box2f", 16},
                                                 {"box2i", 16},
                                                 {"chromaticities", 32},
                                                 {"compression", 1},
                                                 {"deepImageState", 1},
                                                 {"double", 8},
                                                 {"envmap", 1},
                                                 {"float", 4},
                                                 {"int", 4},
                                                 {"keycode", 28},
                                                 {"lineOrder", 1},
                                                 {"m33d", 72},
                                                 {"m33f", 36},
                                                 {"m44d", 128},
                                                 {"m44f", 64},
                                                 {"rational", 8},
                                                 {"tiledesc", 9},
                                                 {"timecode", 8},
                                                 {"v2d", 16},
                                                 {"v2f", 8},
                                                 {"v2i", 8},
                                                 {"v3d", 24},
                                                 {"v3f", 12},
                                                 {"v3i", 12}}};

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::bad_input, "", message); }

// Reads the values of a header; numbers are little-endian.
class HeaderBytes {
 public:
  explicit HeaderBytes(SizedInput& input) : input_(input) {}

  std::uint64_t left() const { return input_.size() - input_.tellg(); }
  std::uint64_t position() const { return input_.tellg(); }
  void skip_to(std::uint64_t position) { input_.seekg(position); }

  std::uint8_t byte() {
    if (left() == 0) refuse("the file ends within its header");
    char value = 0;
    input_.read(&value, 1);
    return static_cast<std::uint8_t>(value);
  }
  std::uint32_t word() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8) value |= static_cast<std::uint32_t>(byte()) << shift;
    return value;
  }
  std::int64_t signed_word() { return static_cast<std::int32_t>(word()); }
  std::string name() {
    std::string text;
    while (const std::uint8_t c = byte()) {
      if (text.size() == longest_name) refuse(fmt::format("a name of more than {} bytes", longest_name));
      text += static_cast<char>(c);
    }
    return text;
  }

 private:
  SizedInput& input_;
};

struct Part {
  std::int64_t lines = 0, width = 0;
  std::uint64_t pixel_bytes = 0;  // of the channels that are kept
  int lines_a_chunk = 0;
  std::uint64_t largest_ratio = 1;
  bool scan_lines = true;
};

// No file of this compression holds more pixel bytes for each of its own: what its densest code gives. Deflate makes
// 258 bytes of two bits, PIZ's Huffman code 255 values of 16 bits of nine, RLE 128 bytes of two; DWA deflates one value
// for a block of 64, B44A stores 3 bytes for a block of 16 values.
std::uint64_t largest_ratio(int compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::RLE_COMPRESSION:
      return 64;
    case Imf::ZIPS_COMPRESSION:
    case Imf::ZIP_COMPRESSION:
      return 1032;
    case Imf::PXR24_COMPRESSION:
      return 4 * 1032 / 3 + 1;
    case Imf::PIZ_COMPRESSION:
      return 454;
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
      return 11;
    default:
      return 64 * 1032;
  }
}

void check_side(std::string_view what, std::int64_t width, std::int64_t height) {
  constexpr std::int64_t max_side = FrameBuffer::max_side;
  if (width < 1 || height < 1 || width > max_side || height > max_side)
    refuse(fmt::format("a {} of {} x {} pixels; 1 to {} a side can be read", what, width, height, max_side));
}

void check_data_window(HeaderBytes& header, Part& part) {
  std::array<std::int64_t, 4> box{};
  for (std::int64_t& side : box) side = header.signed_word();
  part.lines = box[3] - box[1] + 1;
  part.width = box[2] - box[0] + 1;
  check_side("data window", box[2] - box[0] + 1, part.lines);
}

void check_channels(HeaderBytes& header, std::uint64_t end, Part& part) {
  constexpr std::uint64_t bytes_after_name = 16;
  int count = 0;
  for (std::string name = header.name(); !name.empty(); name = header.name()) {
    if (count++ == max_channels) refuse(fmt::format("more than {} channels", max_channels));
    if (header.position() + bytes_after_name >= end) refuse("the channel list is cut off");
    const std::uint64_t after = header.position() + bytes_after_name;
    if (is_plane_name(name)) part.pixel_bytes += header.word() == Imf::HALF ? 2 : 4;
    header.skip_to(after);
  }
  if (header.position() != end) refuse("the channel list is shorter than its attribute");
}

void check_type(const std::string& name, std::string_view type, std::int64_t size) {
  const auto* const fixed =
      std::find_if(fixed_types.begin(), fixed_types.end(), [type](const FixedType& one) { return one.name == type; });
  if (fixed != fixed_types.end() && size != fixed->bytes)
    refuse(fmt::format("attribute '{}' of {} bytes; its type, {}, has {}", name, size, type, fixed->bytes));
  if (type == "floatvector" && size % static_cast<int>(sizeof(float)) != 0)
    refuse(fmt::format("attribute '{}' of {} bytes holds no whole number of floats", name, size));
}

// A reader makes room for all pixels at once.
void check_content(const HeaderBytes& header, const Part& part) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(part.lines) * static_cast<std::uint64_t>(part.width);
  if (pixels * part.pixel_bytes / part.largest_ratio > header.left())
    refuse(fmt::format("{} x {} pixels are more than the {} bytes of the file can hold", part.width, part.lines,
                       header.left()));
}

// Returns false at the end of the part's header.
bool check_attribute(HeaderBytes& header, Part& part) {
  const std::string name = header.name();
  if (name.empty()) return false;
  const std::string type = header.name();
  const std::int64_t size = header.signed_word();
  if (size < 0 || static_cast<std::uint64_t>(size) > header.left())
    refuse(fmt::format("attribute '{}' of {} bytes is longer than the file", name, size));
  check_type(name, type, size);
  const std::uint64_t end = header.position() + static_cast<std::uint64_t>(size);
  if (name == "dataWindow" && size == 16) check_data_window(header, part);
  if (type == "chlist") {
    Part other;  // only those of this name are the file's channels
    check_channels(header, end, name == "channels" ? part : other);
  }
  if (name == "compression" && size == 1) {
    const int compression = header.byte();
    part.lines_a_chunk = lines_per_chunk(compression);
    part.largest_ratio = largest_ratio(compression);
  }
  if (name == "tiles" && size == 9) {
    const std::int64_t width = header.word(), height = header.word();
    check_side("tile", width, height);
    part.scan_lines = false;
  }
  if (name == "chunkCount" && size == 4) {
    const std::int64_t chunks = header.signed_word();
    if (chunks < 0 || static_cast<std::uint64_t>(chunks) > header.left() / table_entry_bytes)
      refuse(fmt::format("{} chunks are more than the file can hold", chunks));
  }
  header.skip_to(end);
  return true;
}

}  // namespace

void check_exr_header(SizedInput& input) {
  input.seekg(0);
  HeaderBytes header(input);
  constexpr std::uint64_t magic_and_version_bytes = 8;
  if (header.left() < magic_and_version_bytes || header.word() != magic_number) refuse("is not an OpenEXR file");
  const std::uint32_t version = header.word();
  const bool plain = (version & (tiled_flag | deep_flag | multipart_flag)) == 0;
  for (bool first = true;; first = false) {
    Part part;
    int attributes = 0;
    while (check_attribute(header, part)) ++attributes;
    if (plain && part.scan_lines && part.lines_a_chunk > 0) {
      const std::int64_t chunks = (part.lines + part.lines_a_chunk - 1) / part.lines_a_chunk;
      if (static_cast<std::uint64_t>(chunks) * table_entry_bytes > header.left())
        refuse(fmt::format("the file ends within its table of {} chunks", chunks));
      check_content(header, part);
    }
    const bool more_parts = (version & multipart_flag) != 0 && attributes > 0;
    if (first && attributes == 0) refuse("the header is empty");
    if (!more_parts) break;
  }
  input.seekg(0);
}

}  // namespace morphcl
