// A look at the header of an OpenEXR file, byte by byte, before a library trusts its sizes.
#pragma once

#include "host/image/exr_stream.hpp"

namespace morphcl {

// Throws Error(bad_input), with no place, for what would make a reader take memory or time that the file does not pay
// for: an attribute or an offset table longer than the file, an attribute of another size than its type has, a data
// window or tile with a side over FrameBuffer::max_side, more pixels than its compression could make of its bytes, more
// than 1024 channels. Leaves the stream at its beginning. What else may be wrong with the file is left to the reader to
// find.
void check_exr_header(SizedInput& input);

}  // namespace morphcl
