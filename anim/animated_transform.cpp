#include "morphcl/animated_transform.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

using Parameters = std::array<double, max_step_parameters>;

[[noreturn]] void refuse_step(const std::string& message) { throw Error(ErrorKind::usage, "", message); }

CompositeTransform first_of_seven(const Parameters& p) {
  const CompositeTransform all = rotation_in_seven_steps({p[0], p[1], p[2]}, {p[3], p[4], p[5]}, p[6]);
  if (!(p[7] >= 0 && p[7] <= 7)) refuse_step(fmt::format("{} of seven steps; 0 to 7 are possible", p[7]));
  CompositeTransform some;
  for (std::size_t i = 0; i < static_cast<std::size_t>(p[7]); ++i) some.add_step(all.steps()[i]);
  return some;
}

CompositeTransform make_step(const AnimatedStep& step, const Parameters& p) {
  CompositeTransform one;
  switch (step.kind) {
    case StepKind::fixed:
      return step.constant;
    case StepKind::translate:
      return one.translate({p[0], p[1], p[2]});
    case StepKind::scale_about:
      return one.scale_about({p[0], p[1], p[2]}, {p[3], p[4], p[5]});
    case StepKind::rotate_x_degrees:
      return one.rotate_x_degrees(p[0]);
    case StepKind::rotate_y_degrees:
      return one.rotate_y_degrees(p[0]);
    case StepKind::rotate_z_degrees:
      return one.rotate_z_degrees(p[0]);
    case StepKind::rotate_about_axis:
      return one.rotate_about_axis({p[0], p[1], p[2]}, {p[3], p[4], p[5]}, p[6]);
    case StepKind::rotate_in_seven_steps:
      return first_of_seven(p);
    case StepKind::shear:
      return one.shear(p[0], p[1], p[2], p[3], p[4], p[5]);
  }
  refuse_step(fmt::format("there is no kind of step {}", static_cast<int>(step.kind)));
}

CompositeTransform step_at(const AnimatedStep& step, std::int64_t tick) {
  Parameters parameters = step.parameters;
  for (const DrivenParameters& driven : step.tracks) driven.track.evaluate(tick, parameters.data() + driven.first);
  const CompositeTransform made = make_step(step, parameters);
  return step.of_axes ? made.inverse() : made;
}

}  // namespace

int parameter_count(StepKind kind) {
  switch (kind) {
    case StepKind::fixed:
      return 0;
    case StepKind::translate:
      return 3;
    case StepKind::scale_about:
    case StepKind::shear:
      return 6;
    case StepKind::rotate_x_degrees:
    case StepKind::rotate_y_degrees:
    case StepKind::rotate_z_degrees:
      return 1;
    case StepKind::rotate_about_axis:
      return 7;
    case StepKind::rotate_in_seven_steps:
      return 8;
  }
  return 0;
}

AnimatedTransform& AnimatedTransform::add(const char* name, AnimatedStep step, int first, int width, Track parameter) {
  if (parameter.empty() || parameter.width() != width)
    refuse_step(fmt::format("{}: its track has {} components; it needs {}", name, parameter.width(), width));
  step.tracks.push_back({first, std::move(parameter)});
  return add_step(std::move(step));
}

AnimatedTransform& AnimatedTransform::translate(Track offset) {
  return add("translate", {StepKind::translate}, 0, 3, std::move(offset));
}

AnimatedTransform& AnimatedTransform::scale_about(const glm::dvec3& point, Track factor) {
  return add("scale_about", {StepKind::scale_about, {point.x, point.y, point.z}}, 3, 3, std::move(factor));
}

AnimatedTransform& AnimatedTransform::rotate_about_axis(const glm::dvec3& from, const glm::dvec3& to, Track degrees) {
  return add("rotate_about_axis", {StepKind::rotate_about_axis, {from.x, from.y, from.z, to.x, to.y, to.z}}, 6, 1,
             std::move(degrees));
}

AnimatedTransform& AnimatedTransform::shear(Track factors) {
  return add("shear", {StepKind::shear}, 0, 6, std::move(factors));
}

AnimatedTransform& AnimatedTransform::fixed(CompositeTransform steps) {
  AnimatedStep step;
  step.constant = std::move(steps);
  return add_step(std::move(step));
}

AnimatedTransform& AnimatedTransform::add_step(AnimatedStep step) {
  for (const DrivenParameters& driven : step.tracks) {
    const int width = driven.track.width();
    if (driven.track.empty() || driven.track.is_rotation())
      refuse_step("a moving parameter needs a track that is neither empty nor one of rotations");
    if (driven.first < 0 || driven.first > parameter_count(step.kind) - width)
      refuse_step(
          fmt::format("a track of {} components from parameter {} on drives parameters that do not exist; the "
                      "step has {}",
                      width, driven.first, parameter_count(step.kind)));
  }
  steps_.push_back(std::move(step));
  return *this;
}

CompositeTransform AnimatedTransform::at(std::int64_t tick) const {
  CompositeTransform transform;
  for (const AnimatedStep& step : steps_) transform.append(step_at(step, tick));
  return transform;
}

bool AnimatedTransform::moves() const {
  return std::ranges::any_of(steps_, [](const AnimatedStep& step) { return !step.tracks.empty(); });
}

}  // namespace morphcl
