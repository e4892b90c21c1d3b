// Pictures of what a method did. Small frames are magnified, so that single pixels can be seen.
#pragma once

#include "host/image/png_file.hpp"
#include "lab/hidden_surfaces/method_run.hpp"

namespace morphcl::hidden_surfaces {

// How many surfaces cover each pixel: black for none, then from dark blue over red to white.
RgbImage overdraw_picture(const MethodRun& run);

// Warnock's quadtree: a window is outlined and filled by why it ended: empty grey, one surface green, surrounded
// orange, one pixel red; where it is large enough, hues of the surfaces are mixed in.
RgbImage quadtree_picture(const MethodRun& run);

// Watkins' sample spans: hues of the surfaces, each span's first pixel dark, what was decided pixel by pixel red.
RgbImage spans_picture(const MethodRun& run);

// Painter and BSP: the place of each shown piece in the order, dark blue for the first, over green to yellow for the
// last; dark lines between surfaces, and red ones where a surface was split.
RgbImage order_picture(const MethodRun& run);

}  // namespace morphcl::hidden_surfaces
