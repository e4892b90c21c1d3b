// 8-bit sRGB pictures and their PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "morphcl/frame.hpp"

namespace morphcl {

struct RgbImage {
  RgbImage(int columns, int rows, Rgb fill)
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill) {}
  Rgb& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x]; }
  const Rgb& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x];
  }

  int width, height;        // pixels, at least 1
  std::vector<Rgb> pixels;  // row by row from the top
};

// Whole or not at all, with the errors of write_file_atomically(). The same image gives the same bytes.
void write_png(const std::string& path, const RgbImage& image);

}  // namespace morphcl
