// The pixels of files with OpenEXR's ZIP compression, read without the library's own path through its general frame
// buffers, which takes several times as long.
#pragma once

#include <ImfHeader.h>

#include <optional>

#include "host/image/exr_stream.hpp"
#include "morphcl/frame.hpp"

namespace morphcl {

// `header`, which was read from `input` up to its offset table, is of a file of one part of scan lines. Nothing when
// the file is of another kind than encode_exr_zip() writes, with other channels or another compression, or when a chunk
// is not where it should be or damaged: OpenEXR is to read it then, or to say what is wrong. Where both read a file
// they read the same pixels.
std::optional<FrameBuffer> read_exr_zip(SizedInput& input, const Imf::Header& header);

}  // namespace morphcl
