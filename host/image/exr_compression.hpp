// The compressions of OpenEXR behind their names; compression_names() is in exr_file.hpp.
#pragma once

#include <ImfCompression.h>

#include <string>
#include <string_view>

#include "host/image/zlib_encoder.hpp"

namespace morphcl {

// Error(usage) lists the names when `name` is none of compression_names().
Imf::Compression exr_compression(const std::string& name);
// How hard `name`, zip or zip:small, looks for fewer bytes.
ZlibEffort zip_effort(const std::string& name);
std::string_view compression_name(Imf::Compression compression);  // "unknown" for what this library does not know

// Whether every value comes back bit for bit, whatever the pixel types.
bool is_lossless(Imf::Compression compression);

// Scan lines that are compressed together; 0 for what this library does not know.
int lines_per_chunk(int compression);

}  // namespace morphcl
