// What a file's header says about its Cryptomatte layers (Cryptomatte specification 1.2, "Metadata").
#pragma once

#include <ImfHeader.h>

#include "morphcl/exr.hpp"

namespace morphcl {

// Four texts for each of the header's Cryptomatte channels: cryptomatte/KEY/name, the layer; /hash, MurmurHash3_32;
// /conversion, uint32_to_float32; /manifest, where it is known. KEY: the first seven hex digits of the hash of the
// layer's name.
void add_cryptomatte(Imf::Header& header, const FrameAttributes& attributes);

}  // namespace morphcl
