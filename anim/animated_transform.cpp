#include "morphcl/animated_transform.hpp"

#include <fmt/core.h>

#include <array>
#include <utility>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {
constexpr int widest_parameter = 6;
}

AnimatedTransform& AnimatedTransform::add(const char* name, int width, Track parameter, decltype(Step::apply) apply) {
  if (parameter.empty() || parameter.width() != width)
    throw Error(ErrorKind::usage, "",
                fmt::format("{}: its track has {} components; it needs {}", name, parameter.width(), width));
  steps_.push_back({std::move(parameter), std::move(apply)});
  return *this;
}

AnimatedTransform& AnimatedTransform::translate(Track offset) {
  return add("translate", 3, std::move(offset),
             [](CompositeTransform& t, const double* v) { t.translate({v[0], v[1], v[2]}); });
}

AnimatedTransform& AnimatedTransform::scale_about(const glm::dvec3& point, Track factor) {
  return add("scale_about", 3, std::move(factor),
             [point](CompositeTransform& t, const double* v) { t.scale_about(point, {v[0], v[1], v[2]}); });
}

AnimatedTransform& AnimatedTransform::rotate_about_axis(const glm::dvec3& from, const glm::dvec3& to, Track degrees) {
  return add("rotate_about_axis", 1, std::move(degrees),
             [from, to](CompositeTransform& t, const double* v) { t.rotate_about_axis(from, to, v[0]); });
}

AnimatedTransform& AnimatedTransform::shear(Track factors) {
  return add("shear", 6, std::move(factors),
             [](CompositeTransform& t, const double* v) { t.shear(v[0], v[1], v[2], v[3], v[4], v[5]); });
}

AnimatedTransform& AnimatedTransform::fixed(CompositeTransform steps) {
  steps_.push_back({Track(), [steps = std::move(steps)](CompositeTransform& t, const double*) { t.append(steps); }});
  return *this;
}

CompositeTransform AnimatedTransform::at(std::int64_t tick) const {
  CompositeTransform transform;
  for (const Step& step : steps_) {
    std::array<double, widest_parameter> parameter{};
    if (!step.parameter.empty()) step.parameter.evaluate(tick, parameter.data());
    step.apply(transform, parameter.data());
  }
  return transform;
}

}  // namespace morphcl
