#include "morphcl/projection.hpp"

namespace morphcl {

namespace {

// Moves both sides outwards by half of what the length lacks; inwards when it has too much.
void set_length(double& low, double& high, double length) {
  const double half = 0.5 * (length - (high - low));
  low -= half;
  high += half;
}

}  // namespace

FittedWindow fitted(const Window& window, Fit fit, double aspect) {
  FittedWindow result{window};
  const double width = window.right - window.left, height = window.top - window.bottom;
  const double full_width = height * aspect;
  if (fit == Fit::stretch || full_width == width) return result;
  const bool too_narrow = full_width > width;
  const bool moves_x = fit == Fit::adjust_x || (fit != Fit::adjust_y && too_narrow == (fit == Fit::widen));
  result.changed = moves_x ? ChangedAxis::x : ChangedAxis::y;
  if (result.changed == ChangedAxis::x)
    set_length(result.window.left, result.window.right, full_width);
  else
    set_length(result.window.bottom, result.window.top, width / aspect);
  return result;
}

}  // namespace morphcl
