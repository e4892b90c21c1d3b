// What a hidden-surface algorithm finds: which surface each pixel shows, of some of the picture's rows.
#pragma once

#include <vector>

#include "host/visibility/screen_surfaces.hpp"

namespace morphcl::visibility {

// Rows first, first + step and so on, so that threads can share a picture.
struct PictureRows {
  int first = 0, step = 1;

  int next_from(int y) const { return y <= first ? first : first + (y - first + step - 1) / step * step; }
  int count(int height) const { return height <= first ? 0 : (height - first + step - 1) / step; }
};

struct ShownRows {
  PictureRows rows;
  int width = 0;
  std::vector<SurfaceId> opaque;  // row by row; no_surface: the background
  // Of algorithms that order all surfaces: what is blended at a pixel, in the order of painting, so back to front.
  struct Layer {
    std::size_t pixel;
    SurfaceId surface;
  };
  std::vector<Layer> layers;
  // Where the order of planes alone would show another surface, or blend layers in another order, than the stored
  // depths do: the two are closer to each other than the error of the stored depths, and the stored depths decided.
  struct WithinError {
    std::size_t pixel;
    SurfaceId shown, by_planes;
  };
  std::vector<WithinError> within_error;

  ShownRows(const PictureRows& picture_rows, int picture_width, int picture_height)
      : rows(picture_rows),
        width(picture_width),
        opaque(static_cast<std::size_t>(picture_width) * static_cast<std::size_t>(picture_rows.count(picture_height)),
               no_surface) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((y - rows.first) / rows.step) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace morphcl::visibility
