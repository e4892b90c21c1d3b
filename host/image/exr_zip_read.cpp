#include "host/image/exr_zip_read.hpp"

#include <Iex.h>
#include <ImfChannelList.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "host/image/exr_byte_merge.hpp"
#include "host/image/exr_planes.hpp"
#include "host/image/exr_zip_chunk.hpp"

namespace morphcl {

namespace {

// The planes of a frame in the file's order. Nothing where some channel is none of them, a channel of the frame lacks
// planes, or a type is another one.
std::optional<std::vector<NamedPlane>> frame_planes(const Imf::ChannelList& channels) {
  std::vector<NamedPlane> planes = planes_in(channels);
  std::size_t all = 0;
  for (auto i = channels.begin(); i != channels.end(); ++i, ++all) {
    const Imf::Channel& channel = i.channel();
    if (channel.xSampling != 1 || channel.ySampling != 1) return std::nullopt;
    if (all < planes.size() && channel.type != static_cast<Imf::PixelType>(plane_type(planes[all].channel)))
      return std::nullopt;
  }
  std::size_t whole = 0;
  for (const Channel channel : channels_of(planes)) whole += static_cast<std::size_t>(plane_count(channel));
  if (all == 0 || all != planes.size() || all != whole) return std::nullopt;
  return planes;
}

// For one thread; its memory is kept from file to file.
class ChunkReader {
 public:
  ChunkReader() {
    if (!inflater_) throw std::bad_alloc();
  }

  // Reads the chunk that stands at `offset` and has this first line into the lines of the frame from y on. False when
  // there is no such chunk.
  bool read(SizedInput& input, std::uint64_t offset, std::int32_t first_line, FrameBuffer& frame,
            const std::vector<NamedPlane>& planes, int y) {
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
      copy_lines(frame, planes, y, lines);
      return true;
    }
    prepared_.resize(std::max(prepared_.size(), bytes));
    if (libdeflate_zlib_decompress(inflater_.get(), data_.data(), data_bytes, prepared_.data(), bytes, nullptr) !=
        LIBDEFLATE_SUCCESS)
      return false;
    add_up_differences(prepared_.data(), bytes);
    merge_lines(frame, planes, y, lines, bytes / 2);
    return true;
  }

 private:
  struct Free {
    void operator()(libdeflate_decompressor* inflater) const { libdeflate_free_decompressor(inflater); }
  };

  // Calls `take` with the bytes of each plane of each line in a chunk's order.
  template <class Take>
  static void for_each_row(FrameBuffer& frame, const std::vector<NamedPlane>& planes, int y, int lines, Take take) {
    std::byte* const memory = frame.data();
    for (int line = y; line < y + lines; ++line)
      for (const NamedPlane& plane : planes)
        take(memory + static_cast<std::size_t>(line) * frame.row_bytes() +
                 frame.plane_offset(plane.channel, plane.plane),
             static_cast<std::size_t>(frame.width()) * bytes_of(plane_type(plane.channel)));
  }

  void copy_lines(FrameBuffer& frame, const std::vector<NamedPlane>& planes, int y, int lines) const {
    const char* from = data_.data();
    for_each_row(frame, planes, y, lines, [&from](std::byte* row, std::size_t bytes) {
      std::memcpy(row, from, bytes);
      from += bytes;
    });
  }

  void merge_lines(FrameBuffer& frame, const std::vector<NamedPlane>& planes, int y, int lines,
                   std::size_t pairs) const {
    const std::uint8_t* even = prepared_.data();
    for_each_row(frame, planes, y, lines, [&even, pairs](std::byte* row, std::size_t bytes) {
      merge_bytes(row, even, even + pairs, bytes / 2);
      even += bytes / 2;
    });
  }

  std::unique_ptr<libdeflate_decompressor, Free> inflater_{libdeflate_alloc_decompressor()};
  std::vector<char> data_;
  std::vector<std::uint8_t> prepared_;
};

std::optional<FrameBuffer> read_chunks(SizedInput& input, const Imath::Box2i& window,
                                       const std::vector<NamedPlane>& planes) {
  thread_local ChunkReader reader;
  FrameBuffer frame(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, channels_of(planes));
  const int chunks = (frame.height() + zip_chunk_lines - 1) / zip_chunk_lines;
  std::vector<std::uint64_t> offsets(static_cast<std::size_t>(chunks));
  input.read(reinterpret_cast<char*>(offsets.data()), chunks * static_cast<int>(sizeof offsets[0]));
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const int y = chunk * zip_chunk_lines;
    if (!reader.read(input, offsets[static_cast<std::size_t>(chunk)], window.min.y + y, frame, planes, y))
      return std::nullopt;
  }
  return frame;
}

}  // namespace

std::optional<FrameBuffer> read_exr_zip(SizedInput& input, const Imf::Header& header) {
  try {
    if (header.compression() != Imf::ZIP_COMPRESSION || header.lineOrder() != Imf::INCREASING_Y) return std::nullopt;
    const std::optional<std::vector<NamedPlane>> planes = frame_planes(header.channels());
    if (!planes) return std::nullopt;
    return read_chunks(input, header.dataWindow(), *planes);
  } catch (const Iex::BaseExc&) {
    return std::nullopt;
  }
}

}  // namespace morphcl
