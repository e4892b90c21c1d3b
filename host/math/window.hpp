// The window: the rectangle of the picture's plane that an image shows, and how it is brought to the image's
// proportions.
#pragma once

namespace morphcl {

struct Window {
  double left = -1, right = 1, bottom = -1, top = 1;  // left < right, bottom < top
};

enum class Fit {
  stretch,  // the window fills the image as it is: x and y are drawn to different scales where the proportions differ
  widen,    // along the axis that falls short, both sides move outwards: all of the window shows, undistorted
  crop,     // along the axis that is too long, both sides move inwards: undistorted, but parts of the window are lost
};

enum class ChangedAxis { none, x, y };

struct FittedWindow {
  Window window;
  ChangedAxis changed = ChangedAxis::none;  // the axis that was widened or cropped; the other one keeps its bits
};

// `aspect` is width / height of the image, > 0. Both sides move by the same amount, so the centre stays.
FittedWindow fitted(const Window& window, Fit fit, double aspect);

}  // namespace morphcl
