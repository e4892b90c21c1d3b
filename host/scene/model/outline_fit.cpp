#include "host/scene/model/outline_fit.hpp"

#include <algorithm>

namespace morphcl {

namespace {

// One direction of the picture: edges of the slopes center + 1 / t and center - 1 / t.
class Side {
 public:
  Side(const Farthest& points, int axis, double center, double half)
      : points_(points), axis_(axis), center_(center), t_(1 / half), max_t_(max_narrowing / half) {
    touch();
  }

  // The nearest eye's z.
  double eye_z() const { return 0.5 * (right_.y + right_.x * t_) + 0.5 * (left_.y - left_.x * t_); }
  // The place across of an eye at z.
  double eye_across(double z) const {
    return 0.5 * (right_.y - left_.y) / t_ + 0.5 * (right_.x + left_.x) - center_ * z;
  }

  // Makes the edges those between which the points just lie, seen from z, which is not below eye_z().
  void narrow_to(double z) {
    while (eye_z() < z && t_ < max_t_) {
      // One point alone may lie on both edges: then others do between much narrower ones, unless all are drawn as one.
      const double rise = 0.5 * (right_.x - left_.x);
      const double next = rise > 0 ? t_ + (z - eye_z()) / rise : 8 * t_;
      if (!(next > t_)) return;
      t_ = std::min(next, max_t_);
      touch();
    }
    while (eye_z() > z) {
      const double rise = 0.5 * (right_.x - left_.x), next = t_ - (eye_z() - z) / rise;
      if (!(rise > 0 && next < t_)) return;
      t_ = next;
      touch();
    }
  }

 private:
  static constexpr double max_narrowing = 1e7;  // less than a pixel of the largest picture

  // The points on the edges, as (across, z), the shear applied.
  void touch() {
    right_ = farthest(t_);
    left_ = farthest(-t_);
  }
  glm::dvec2 farthest(double t) const {
    glm::dvec3 direction(0, 0, 1 + center_ * t);
    direction[axis_] = t;
    const glm::dvec3 point = points_(direction);
    return {point[axis_] + center_ * point.z, point.z};
  }

  const Farthest& points_;
  int axis_;
  double center_, t_, max_t_;
  glm::dvec2 right_{0.0}, left_{0.0};
};

}  // namespace

Extent extent_along(const Farthest& points, const glm::dvec3& direction) {
  return {glm::dot(points(-direction), direction), glm::dot(points(direction), direction)};
}

glm::dvec3 fitted_eye(const Farthest& points, const glm::dvec2& center, const glm::dvec2& half, double min_distance) {
  Side across(points, 0, center.x, half.x), up(points, 1, center.y, half.y);
  const double nearest = points({0, 0, 1}).z;
  const double z = std::max({across.eye_z(), up.eye_z(), nearest + min_distance});
  across.narrow_to(z);
  up.narrow_to(z);
  return {across.eye_across(z), up.eye_across(z), z};
}

}  // namespace morphcl
