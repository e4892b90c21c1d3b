// The compressions of OpenEXR by their names in shot files and on the command line.
#pragma once

#include <ImfCompression.h>

#include <string>
#include <string_view>
#include <vector>

namespace morphcl {

// none rle zips zip piz pxr24 b44 b44a dwaa dwab
const std::vector<std::string>& compression_names();

// Error(usage) lists the names when `name` is none of them.
Imf::Compression exr_compression(const std::string& name);
std::string_view compression_name(Imf::Compression compression);  // "unknown" for what this library does not know

// Whether every value comes back bit for bit, whatever the pixel types.
bool is_lossless(Imf::Compression compression);

// Scan lines that are compressed together; 0 for what this library does not know.
int lines_per_chunk(Imf::Compression compression);

}  // namespace morphcl
