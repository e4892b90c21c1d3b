// Chunks of a scan line file with OpenEXR's ZIP compression: 16 lines of all planes, prepared (ExrByteSplit),
// deflated.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/image/blank_spans.hpp"
#include "host/image/channel_planes.hpp"
#include "host/image/zlib_encoder.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

inline constexpr int zip_chunk_lines = 16;

// Keeps its memory from frame to frame; for one thread at a time.
class ExrZipChunks {
 public:
  explicit ExrZipChunks(ZlibEffort effort) : encoder_(make_zlib_encoder(effort)) {}

  // Forgets the chunk before: encode() is about another frame now. `planes`: all of the frame's, in the file's order;
  // they stay until the last call of encode().
  void begin(const FrameBuffer& frame, std::span<const NamedPlane> planes);
  // The data of the chunk whose first line is `first_line`, a multiple of 16; it stays until the next call. A chunk
  // that does not shrink is stored as it is: OpenEXR tells the two apart by their length. One with the same lines as
  // the one before costs a comparison, one whose blocks are known to be blank, like the one before, costs nothing.
  std::span<const std::uint8_t> encode(int first_line);

 private:
  void prepare(int first_line, int lines);
  std::uint32_t checksum(int lines) const;
  void store(int first_line, int lines);

  std::unique_ptr<ZlibEncoder> encoder_;
  const FrameBuffer* frame_ = nullptr;
  std::span<const NamedPlane> planes_;
  std::vector<PixelSpan> spans_;  // of a line of the chunk
  std::vector<std::uint8_t> prepared_, prepared_before_, data_;
  std::size_t data_bytes_ = 0;
  int lines_before_ = 0;  // 0: no chunk before
  bool blank_before_ = false;
};

// Bytes of a line of all planes, before compression.
std::size_t line_bytes(const FrameBuffer& frame);

}  // namespace morphcl
