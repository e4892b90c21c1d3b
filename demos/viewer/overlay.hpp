// Text in a darkened box over a picture.
#pragma once

#include <string>
#include <vector>

#include "demos/viewer/demo_state.hpp"
#include "host/image/png_file.hpp"

namespace morphcl::viewer {

// One line a key that means something within `limits`.
std::vector<std::string> help_lines(const DemoLimits& limits);

// In the upper left corner, as large as fits beside the picture's right half (1 to 4 pixels a dot); what does not fit
// is cut off.
void draw_text_box(const std::vector<std::string>& lines, RgbImage& picture);

}  // namespace morphcl::viewer
