#include "host/geometry/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

glm::dvec3 magnitude(const Box& box) { return glm::max(glm::abs(box.lower), glm::abs(box.upper)); }

Box scaled(const Box& box, const Interval& factor) {
  const glm::dvec3 a = factor.lower * box.lower, b = factor.lower * box.upper;
  const glm::dvec3 c = factor.upper * box.lower, d = factor.upper * box.upper;
  return {glm::min(glm::min(a, b), glm::min(c, d)), glm::max(glm::max(a, b), glm::max(c, d))};
}

Box sum(const Box& a, const Box& b) { return {a.lower + b.lower, a.upper + b.upper}; }

Box widened(const Box& box, const glm::dvec3& margin) { return {box.lower - margin, box.upper + margin}; }

}  // namespace

bool Box::contains(const glm::dvec3& point) const {
  return glm::all(glm::lessThanEqual(lower, point)) && glm::all(glm::lessThanEqual(point, upper));
}

glm::dvec3 Box::corner(int i) const {
  return {i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z};
}

void Box::include(const glm::dvec3& point) {
  lower = glm::min(lower, point);
  upper = glm::max(upper, point);
}

void Box::include(const Box& other) {
  lower = glm::min(lower, other.lower);
  upper = glm::max(upper, other.upper);
}

Box intersection(const Box& a, const Box& b) { return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)}; }

Box box_of(const std::vector<glm::vec3>& points) {
  Box box;
  for (const glm::vec3& point : points) box.include(glm::dvec3(point));
  return box;
}

Box transformed(const Box& box, const glm::dmat4& matrix) {
  Box result;
  if (box.empty()) return result;
  for (int i = 0; i < 8; ++i) result.include(glm::dvec3(matrix * glm::dvec4(box.corner(i), 1.0)));
  return result;
}

Sphere sphere_of(const Box& box) { return {box.center(), glm::length(0.5 * box.upper - 0.5 * box.lower)}; }

MorphBounds::MorphBounds(const Mesh& mesh) : base_(box_of(mesh.positions)) {
  targets_.reserve(mesh.targets.size());
  for (const MorphTarget& target : mesh.targets) {
    Target bounds;
    bounds.absolute = target.form == TargetForm::absolute;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const glm::dvec3 base(mesh.positions[i]);
      if (target.positions.empty()) {
        bounds.positions.include(base);
        bounds.deltas.include(glm::dvec3(0.0));
        continue;
      }
      const glm::dvec3 value(target.positions[i]);
      const bool absolute = target.form == TargetForm::absolute;
      bounds.positions.include(absolute ? value : base + value);
      bounds.deltas.include(absolute ? value - base : value);
    }
    targets_.push_back(bounds);
  }
}

template <class IntervalOf>
Box MorphBounds::at_intervals(std::size_t count, IntervalOf interval_of) const {
  if (count != targets_.size())
    throw Error(ErrorKind::internal, "",
                fmt::format("bounds of {} morph targets were asked for with {} weights", targets_.size(), count));
  Box by_deltas = base_, by_positions{glm::dvec3(0.0), glm::dvec3(0.0)};
  Interval rest{1, 1};
  glm::dvec3 magnitudes = magnitude(base_);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Interval weight = interval_of(i);
    const double size = std::max(std::abs(weight.lower), std::abs(weight.upper));
    if (size == 0) continue;
    by_deltas = sum(by_deltas, scaled(targets_[i].deltas, weight));
    by_positions = sum(by_positions, scaled(targets_[i].positions, weight));
    rest = {rest.lower - weight.upper, rest.upper - weight.lower};
    magnitudes += size * (magnitude(targets_[i].deltas) + magnitude(targets_[i].positions) + magnitude(base_));
  }
  by_positions = sum(by_positions, scaled(base_, rest));
  const double ulps = static_cast<double>(targets_.size()) + 2;
  const glm::dvec3 margin = ulps * std::ldexp(1.0, -23) * magnitudes;
  return widened(intersection(by_deltas, by_positions), margin);
}

Box MorphBounds::at(const std::vector<double>& weights) const {
  return at_intervals(weights.size(), [&](std::size_t i) { return Interval{weights[i], weights[i]}; });
}

Box MorphBounds::at(const std::vector<Interval>& weights) const {
  return at_intervals(weights.size(), [&](std::size_t i) { return weights[i]; });
}

glm::dvec3 MorphBounds::terms(const std::vector<double>& weights, const glm::dvec3& pivot) const {
  const auto relative = [&](const Box& box) { return magnitude({box.lower - pivot, box.upper - pivot}); };
  glm::dvec3 sum = relative(base_);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    sum += std::abs(weights[i]) *
           (target.absolute ? relative(target.positions) + relative(base_) : magnitude(target.deltas));
  }
  return sum;
}

}  // namespace morphcl
