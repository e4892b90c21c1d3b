#include "demos/viewer/matching_projection.hpp"

#include <algorithm>
#include <cmath>

#include "morphcl/projection.hpp"

namespace morphcl::viewer {
namespace {

constexpr double kFarInDistances = 1000.0;   // stands for an infinite far plane
constexpr double kNearInDistances = 1.0e-3;  // stands for a near plane that a frustum cannot have

Window scaled(const Window& window, double factor) {
  return {window.left * factor, window.right * factor, window.bottom * factor, window.top * factor};
}

// What shows of the plane `distance` in front of the eye.
Window window_at(const Projection& projection, double distance, double aspect) {
  const Window window = fitted_window(projection, aspect).window;
  if (is_parallel(projection)) return window;
  if (const auto* frustum = std::get_if<Frustum>(&projection)) return scaled(window, distance / frustum->near);
  if (const auto* central = std::get_if<CentralProjection>(&projection))
    return scaled(window, distance / central->board);
  return scaled(window, distance);
}

template <typename Planes>
Planes widened_planes(Planes planes, double aspect) {
  const Window window = fitted({planes.left, planes.right, planes.bottom, planes.top}, Fit::widen, aspect).window;
  planes.left = window.left;
  planes.right = window.right;
  planes.bottom = window.bottom;
  planes.top = window.top;
  return planes;
}

}  // namespace

Orthographic matching_orthographic(const Projection& projection, double distance, double aspect) {
  if (const auto* same = std::get_if<Orthographic>(&projection)) return *same;
  const Window sides = window_at(projection, distance, aspect);
  const double far = std::isinf(far_distance(projection)) ? kFarInDistances * distance : far_distance(projection);
  return {sides.left, sides.right, sides.bottom, sides.top, near_distance(projection), far};
}

Frustum matching_frustum(const Projection& projection, double distance, double aspect) {
  if (const auto* same = std::get_if<Frustum>(&projection)) return *same;
  const double near = std::max(near_distance(projection), kNearInDistances * distance);
  const double far = std::max(far_distance(projection), 2 * near);
  const Window sides = scaled(window_at(projection, distance, aspect), near / distance);
  return {sides.left, sides.right, sides.bottom, sides.top, near, far};
}

Projection zoomed(const Projection& projection, double factor, double aspect) {
  const Window sides = scaled(fitted_window(projection, aspect).window, factor);
  const auto with_sides = [&sides](auto planes) {
    planes.left = sides.left;
    planes.right = sides.right;
    planes.bottom = sides.bottom;
    planes.top = sides.top;
    planes.fit = Fit::stretch;
    return planes;
  };
  if (const auto* oblique = std::get_if<Oblique>(&projection)) return with_sides(*oblique);
  return with_sides(std::get<Orthographic>(projection));
}

Orthographic widened(const Orthographic& planes, double aspect) { return widened_planes(planes, aspect); }

Frustum widened(const Frustum& planes, double aspect) { return widened_planes(planes, aspect); }

}  // namespace morphcl::viewer
