#include "host/render/plan/motion_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "host/math/finite.hpp"
#include "morphcl/rotation.hpp"

namespace morphcl {

namespace {

// The binary64 arithmetic of a chain of at most 64 nodes is off by far less than this part of the magnitudes.
constexpr double rounding = 1e-12;
constexpr int max_moving_nodes = 64;

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// At least the factor by which the matrix stretches any vector: the root of the largest row sum of A^T A (Gershgorin),
// exact where the columns are at right angles.
double stretch(const glm::dmat3& a) {
  double max_scale = 0;
  for (int i = 0; i < 3; ++i) {
    double row = 0;
    for (int j = 0; j < 3; ++j) row += std::abs(glm::dot(a[i], a[j]));
    max_scale = std::max(max_scale, row);
  }
  return std::sqrt(max_scale) * (1 + rounding);
}

// The largest sum of magnitudes in a row.
double row_sum(const glm::dmat3& a) {
  double max_sum = 0;
  for (int row = 0; row < 3; ++row)
    max_sum = std::max(max_sum, std::abs(a[0][row]) + std::abs(a[1][row]) + std::abs(a[2][row]));
  return max_sum;
}

struct VectorRange {
  glm::dvec3 middle, half;
};

VectorRange range_of(const Track& track, const glm::dvec3& constant) {
  if (track.empty()) return {constant, glm::dvec3(0.0)};
  VectorRange range;
  for (int i = 0; i < 3; ++i) {
    const ValueRange values = track.range(i);
    range.middle[i] = 0.5 * values.lower + 0.5 * values.upper;
    range.half[i] = (0.5 * values.upper - 0.5 * values.lower) + rounding * std::max(-values.lower, values.upper);
  }
  return range;
}

// A ball that contains the object, and a bound of the terms that its vertices' coordinates are sums of.
struct Ball {
  glm::dvec3 center;
  double radius, magnitude;

  void apply(const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    center = glm::dvec3(matrix * glm::dvec4(center, 1.0));
    radius *= stretch(linear);
    magnitude = row_sum(linear) * magnitude + largest(glm::dvec3(matrix[3]));
  }
  void scale(const VectorRange& factor) {
    const double max_factor = largest(glm::abs(factor.middle) + factor.half);
    radius = radius * max_factor + glm::length(factor.half * center);
    center *= factor.middle;
    magnitude *= max_factor;
  }
  void turn_anyhow() {
    radius += glm::length(center);
    center = glm::dvec3(0.0);
    magnitude *= 2;  // the root of 3 at most
  }
  void move(const VectorRange& offset) {
    center += offset.middle;
    radius += glm::length(offset.half);
    magnitude += largest(glm::abs(offset.middle) + offset.half);
  }
};

VectorRange parameter_range(const AnimatedStep& step, int first) {
  VectorRange range{glm::dvec3(step.parameters[first], step.parameters[first + 1], step.parameters[first + 2]),
                    glm::dvec3(0.0)};
  for (const DrivenParameters& driven : step.tracks)
    if (driven.first == first && driven.track.width() == 3) range = range_of(driven.track, range.middle);
  return range;
}

VectorRange negative(const VectorRange& range) { return {-range.middle, range.half}; }

// False where no bound of the step is known.
bool apply_step(const AnimatedStep& step, Ball& ball) {
  if (step.tracks.empty()) {
    AnimatedTransform still;
    still.add_step(step);
    ball.apply(still.at(0).matrix());
    return true;
  }
  const auto is_whole = [](const DrivenParameters& driven) { return driven.first % 3 == 0; };
  switch (step.kind) {
    case StepKind::translate: {
      const VectorRange offset = parameter_range(step, 0);
      ball.move(step.of_axes ? negative(offset) : offset);
      return std::ranges::all_of(step.tracks, is_whole);
    }
    case StepKind::scale_about: {
      const VectorRange point = parameter_range(step, 0);
      ball.move(negative(point));
      ball.scale(parameter_range(step, 3));
      ball.move(point);
      return !step.of_axes && std::ranges::all_of(step.tracks, is_whole);
    }
    case StepKind::rotate_x_degrees:
    case StepKind::rotate_y_degrees:
    case StepKind::rotate_z_degrees:
      ball.turn_anyhow();
      return true;
    case StepKind::rotate_about_axis: {
      const VectorRange from = parameter_range(step, 0);
      ball.move(negative(from));
      ball.turn_anyhow();
      ball.move(from);
      return std::ranges::all_of(step.tracks, is_whole);
    }
    case StepKind::fixed:
    case StepKind::rotate_in_seven_steps:  // its formulas hold in a narrow range alone
    case StepKind::shear:
      return false;
  }
  return false;
}

// False where no bound of the node's motion is known.
bool apply_node(const Node& node, Ball& ball) {
  if (node.steps.empty()) ball.apply(node.static_transform);
  for (const AnimatedStep& step : node.steps.steps())
    if (!apply_step(step, ball)) return false;
  ball.scale(range_of(node.scale_track, node.scale));
  if (node.rotation_track.empty())
    ball.apply(glm::dmat4(rotation_matrix(node.rotation)));
  else
    ball.turn_anyhow();
  ball.move(range_of(node.translation_track, node.translation));
  return true;
}

BoundedBox still_bounds(const Box& box, const glm::dmat4& to_world) {
  const glm::dvec3 center = box.center(), half = 0.5 * box.upper - 0.5 * box.lower;
  const glm::dvec3 corner = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  BoundedBox bounds{glm::dvec3(to_world * glm::dvec4(center, 1.0)), glm::dvec3(0.0), glm::abs(glm::dvec3(to_world[3]))};
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3 absolute = glm::abs(glm::dvec3(to_world[column]));
    bounds.half += absolute * half[column];
    bounds.magnitude += absolute * corner[column];
  }
  bounds.half += rounding * bounds.magnitude;
  return bounds;
}

}  // namespace

void weight_ranges(const MorphWeights& morph, std::vector<Interval>& ranges) {
  ranges.clear();
  for (const double weight : morph.weights) ranges.push_back({weight, weight});
  for (const WeightTrack& driven : morph.tracks) {
    if (driven.track.empty()) continue;
    for (int i = 0; i < driven.track.width(); ++i) {
      const ValueRange values = driven.track.range(i);
      const double ulps = rounding * std::max(-values.lower, values.upper);
      ranges[driven.first_target + i] = {values.lower - ulps, values.upper + ulps};
    }
  }
}

std::optional<BoundedBox> bounds_over_time(const std::vector<Node>& nodes, const NodeSampler& sampler, int node,
                                           const Box& box) {
  BoundedBox bounds;
  if (sampler.is_still(node)) {
    bounds = still_bounds(box, sampler.still_to_world(node));
  } else {
    const Sphere sphere = sphere_of(box);
    Ball ball{sphere.center, sphere.radius, std::max(largest(box.lower), largest(box.upper))};
    int moving = 0;
    for (; node >= 0 && !sampler.is_still(node); node = nodes[node].parent) {
      if (++moving > max_moving_nodes) return std::nullopt;
      if (!apply_node(nodes[node], ball)) return std::nullopt;
    }
    if (node >= 0) ball.apply(sampler.still_to_world(node));
    bounds = {ball.center, glm::dvec3(ball.radius + rounding * ball.magnitude), glm::dvec3(ball.magnitude)};
  }
  if (!is_finite(bounds.center) || !is_finite(bounds.half) || !is_finite(bounds.magnitude)) return std::nullopt;
  return bounds;
}

}  // namespace morphcl
