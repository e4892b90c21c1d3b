// Files with OpenEXR's ZIP compression, written without the library's own path through its general frame buffers, which
// takes ten times as long.
#pragma once

#include <ImfHeader.h>

#include <vector>

#include "host/image/zlib_encoder.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

// Replaces `bytes` by the file: one part of scan lines from the top, `header` (which says ZIP_COMPRESSION and has the
// size of `frame` and its channels as named_planes(frame.channels(), names)), offset table, chunks. `threads` >= 1
// share the chunks of the frame; the bytes do not depend on them.
void encode_exr_zip(std::vector<char>& bytes, const Imf::Header& header, const FrameBuffer& frame, ChannelNames names,
                    ZlibEffort effort, int threads);

}  // namespace morphcl
