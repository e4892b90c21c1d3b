#include "demos/viewer/matching_projection.hpp"

#include <algorithm>
#include <cmath>

#include "host/math/angle.hpp"

namespace morphcl::viewer {
namespace {

constexpr double kFarInDistances = 1000.0;   // stands for an infinite far plane
constexpr double kNearInDistances = 1.0e-3;  // stands for a near plane that a frustum cannot have

// The planes at distance 1 from the eye (central) or anywhere (parallel).
struct Sides {
  double left, right, bottom, top;
};

Sides scaled(const Sides& sides, double factor) {
  return {sides.left * factor, sides.right * factor, sides.bottom * factor, sides.top * factor};
}

// Where the planes meet the plane `distance` in front of the eye.
Sides sides_at(const Projection& projection, double distance, double aspect) {
  if (const auto* perspective = std::get_if<Perspective>(&projection)) {
    const SinCos half = sin_cos_degrees(perspective->fovy_degrees / 2);
    const double height = distance * half.sin / half.cos;
    return {-height * aspect, height * aspect, -height, height};
  }
  if (const auto* frustum = std::get_if<Frustum>(&projection)) {
    return scaled({frustum->left, frustum->right, frustum->bottom, frustum->top}, distance / frustum->near);
  }
  const auto& planes = std::get<Orthographic>(projection);
  return {planes.left, planes.right, planes.bottom, planes.top};
}

template <typename Planes>
Planes widened_planes(Planes planes, double aspect) {
  const double width = planes.right - planes.left, height = planes.top - planes.bottom;
  const double more_width = std::max(0.0, height * aspect - width),
               more_height = std::max(0.0, width / aspect - height);
  planes.left -= more_width / 2;
  planes.right += more_width / 2;
  planes.bottom -= more_height / 2;
  planes.top += more_height / 2;
  return planes;
}

}  // namespace

Orthographic matching_orthographic(const Projection& projection, double distance, double aspect) {
  if (const auto* same = std::get_if<Orthographic>(&projection)) return *same;
  const Sides sides = sides_at(projection, distance, aspect);
  const double far = std::isinf(far_distance(projection)) ? kFarInDistances * distance : far_distance(projection);
  return {sides.left, sides.right, sides.bottom, sides.top, near_distance(projection), far};
}

Frustum matching_frustum(const Projection& projection, double distance, double aspect) {
  if (const auto* same = std::get_if<Frustum>(&projection)) return *same;
  const double near = std::max(near_distance(projection), kNearInDistances * distance);
  const double far = std::max(far_distance(projection), 2 * near);
  const Sides sides = scaled(sides_at(projection, distance, aspect), near / distance);
  return {sides.left, sides.right, sides.bottom, sides.top, near, far};
}

Orthographic widened(const Orthographic& planes, double aspect) { return widened_planes(planes, aspect); }

Frustum widened(const Frustum& planes, double aspect) { return widened_planes(planes, aspect); }

}  // namespace morphcl::viewer
