// A composite transform whose parameters move: named steps in order, evaluated at a time.
//
// Each adder takes the step's moving parameter as a track and the rest as constants; the conventions are those of
// CompositeTransform. Error(usage) when the track is empty or has the wrong width.
//
// For callers that evaluate transforms themselves: a Node moves by its own tracks. Ticks are those of the time base
// that all tracks were made with (TimeBase::frame_ticks).
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "morphcl/track.hpp"
#include "morphcl/transform.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

class AnimatedTransform {
 public:
  AnimatedTransform& translate(Track offset);                                                         // width 3
  AnimatedTransform& scale_about(const glm::dvec3& point, Track factor);                              // width 3
  AnimatedTransform& rotate_about_axis(const glm::dvec3& from, const glm::dvec3& to, Track degrees);  // width 1
  AnimatedTransform& shear(Track factors);             // width 6: xy xz yx yz zx zy
  AnimatedTransform& fixed(CompositeTransform steps);  // steps that do not move

  // A pure function of the tick. Error(usage) when a parameter, moving or constant, is not finite or degenerate
  // (CompositeTransform says which are).
  CompositeTransform at(std::int64_t tick) const;

 private:
  struct Step {
    Track parameter;  // empty for fixed steps
    std::function<void(CompositeTransform&, const double*)> apply;
  };
  AnimatedTransform& add(const char* name, int width, Track parameter, decltype(Step::apply) apply);
  std::vector<Step> steps_;
};

}  // namespace morphcl
#pragma GCC visibility pop
