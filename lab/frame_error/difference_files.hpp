// A frame's differences as files: planes for compositors, a picture and a table for people.
#pragma once

#include <string>
#include <vector>

#include "host/image/png_file.hpp"
#include "lab/frame_error/frame_difference.hpp"

namespace morphcl::accuracy {

// EXR of float channels: R, G, B, A (absolute), Z (relative), mask (PixelDifference as 0 to 3).
void write_difference_exr(const std::string& path, const FrameDifference& difference);

// The colour error of each pixel (of Z where there is no colour) from dark to white, twice the error 6 codes brighter,
// 2^-34 and less black; on it, a pixel wider on each side so that they can be seen: outline red, edge yellow, order
// magenta.
RgbImage difference_picture(const FrameDifference& difference);

// One line for the header, one for each frame and one for each object in it, the object's name in quotes.
std::string csv_header();
std::string csv_lines(const FrameDifference& difference);

std::string name_of(Truth truth);  // "grid", "true"

}  // namespace morphcl::accuracy
