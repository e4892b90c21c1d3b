#include "host/image/exr_zip_read.hpp"

#include <Iex.h>
#include <ImfChannelList.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include "host/image/exr_byte_merge.hpp"
#include "host/image/exr_planes.hpp"
#include "host/image/exr_zip_chunk.hpp"

namespace morphcl {

namespace {

// Nothing for other channels than R, G, B, A as half and Z as float.
std::optional<ChannelSet> frame_channels(const Imf::ChannelList& channels) {
  int color = 0, depth = 0, all = 0;
  for (auto i = channels.begin(); i != channels.end(); ++i, ++all) {
    const std::string_view name = i.name();
    const Imf::Channel& channel = i.channel();
    if (channel.xSampling != 1 || channel.ySampling != 1) return std::nullopt;
    if (std::find(color_channel_names.begin(), color_channel_names.end(), name) != color_channel_names.end())
      color += channel.type == Imf::HALF;
    else if (name == depth_channel_name)
      depth += channel.type == Imf::FLOAT;
  }
  if (all == 0 || all != color + depth || (color != 0 && color != 4)) return std::nullopt;
  ChannelSet found;
  found.set(Channel::color, color == 4);
  found.set(Channel::depth, depth == 1);
  return found;
}

// For one thread; its memory is kept from file to file.
class ChunkReader {
 public:
  ChunkReader() {
    if (!inflater_) throw std::bad_alloc();
  }

  // Reads the chunk that stands at `offset` and has this first line into the lines of the frame from y on. False when
  // there is no such chunk.
  bool read(SizedInput& input, std::uint64_t offset, std::int32_t first_line, FrameBuffer& frame, int y) {
    const int lines = std::min(zip_chunk_lines, frame.height() - y);
    const std::size_t bytes = line_bytes(frame) * static_cast<std::size_t>(lines);
    std::array<std::int32_t, 2> opening{};  // first line, bytes of the data
    input.seekg(offset);
    input.read(reinterpret_cast<char*>(opening.data()), sizeof opening);
    if (opening[0] != first_line || opening[1] < 1 || static_cast<std::size_t>(opening[1]) > bytes) return false;
    const auto data_bytes = static_cast<std::size_t>(opening[1]);
    data_.resize(std::max(data_.size(), bytes));
    input.read(data_.data(), opening[1]);
    if (data_bytes == bytes) {
      copy_lines(frame, y, lines);
      return true;
    }
    prepared_.resize(std::max(prepared_.size(), bytes));
    if (libdeflate_zlib_decompress(inflater_.get(), data_.data(), data_bytes, prepared_.data(), bytes, nullptr) !=
        LIBDEFLATE_SUCCESS)
      return false;
    add_up_differences(prepared_.data(), bytes);
    merge_lines(frame, y, lines, bytes / 2);
    return true;
  }

 private:
  struct Free {
    void operator()(libdeflate_decompressor* inflater) const { libdeflate_free_decompressor(inflater); }
  };

  // Calls `take` with the pixels of each channel of each line in a chunk's order.
  template <class Take>
  static void for_each_row(FrameBuffer& frame, int y, int lines, Take take) {
    for (int line = y; line < y + lines; ++line) {
      if (frame.has_color())
        for (const int channel : alphabetical_channels) take(frame.color_row(channel, line));
      if (frame.has_depth()) take(frame.depth_row(line));
    }
  }

  void copy_lines(FrameBuffer& frame, int y, int lines) const {
    const char* from = data_.data();
    for_each_row(frame, y, lines, [&from](const auto& row) {
      std::memcpy(row.data(), from, row.size_bytes());
      from += row.size_bytes();
    });
  }

  void merge_lines(FrameBuffer& frame, int y, int lines, std::size_t pairs) const {
    const std::uint8_t* even = prepared_.data();
    for_each_row(frame, y, lines, [&even, pairs](const auto& row) {
      const std::size_t count = row.size_bytes() / 2;
      merge_bytes(row.data(), even, even + pairs, count);
      even += count;
    });
  }

  std::unique_ptr<libdeflate_decompressor, Free> inflater_{libdeflate_alloc_decompressor()};
  std::vector<char> data_;
  std::vector<std::uint8_t> prepared_;
};

std::optional<FrameBuffer> read_chunks(SizedInput& input, const Imath::Box2i& window, ChannelSet channels) {
  thread_local ChunkReader reader;
  FrameBuffer frame(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, channels);
  const int chunks = (frame.height() + zip_chunk_lines - 1) / zip_chunk_lines;
  std::vector<std::uint64_t> offsets(static_cast<std::size_t>(chunks));
  input.read(reinterpret_cast<char*>(offsets.data()), chunks * static_cast<int>(sizeof offsets[0]));
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const int y = chunk * zip_chunk_lines;
    if (!reader.read(input, offsets[static_cast<std::size_t>(chunk)], window.min.y + y, frame, y)) return std::nullopt;
  }
  return frame;
}

}  // namespace

std::optional<FrameBuffer> read_exr_zip(SizedInput& input, const Imf::Header& header) {
  try {
    if (header.compression() != Imf::ZIP_COMPRESSION || header.lineOrder() != Imf::INCREASING_Y) return std::nullopt;
    const std::optional<ChannelSet> channels = frame_channels(header.channels());
    if (!channels) return std::nullopt;
    return read_chunks(input, header.dataWindow(), *channels);
  } catch (const Iex::BaseExc&) {
    return std::nullopt;
  }
}

}  // namespace morphcl
