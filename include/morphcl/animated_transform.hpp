// A composite transform whose parameters move: named steps in order, evaluated at a time.
//
// Each adder takes the step's moving parameter as a track and the rest as constants; add_step() takes a step of which
// any number moves. The conventions are those of CompositeTransform. Error(usage) when a track is empty or has the
// wrong width.
//
// A Node has one of these in the place of its static_transform. Ticks are those of the time base that all tracks were
// made with (TimeBase::frame_ticks).
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "morphcl/track.hpp"
#include "morphcl/transform.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// The steps of CompositeTransform, and what their parameters are, in this order.
enum class StepKind {
  fixed,                  // none: AnimatedStep::constant as it is
  translate,              // x y z
  scale_about,            // point x y z, factor x y z
  rotate_x_degrees,       // degrees
  rotate_y_degrees,       // degrees
  rotate_z_degrees,       // degrees
  rotate_about_axis,      // from x y z, to x y z, degrees
  rotate_in_seven_steps,  // from x y z, to x y z, degrees, how many of the seven steps
  shear                   // xy xz yx yz zx zy
};

constexpr int max_step_parameters = 8;
int parameter_count(StepKind kind);

struct DrivenParameters {
  int first = 0;  // the track's width() components replace parameters first, first + 1, ...
  Track track;
  bool operator==(const DrivenParameters&) const = default;
};

struct AnimatedStep {
  StepKind kind = StepKind::fixed;
  std::array<double, max_step_parameters> parameters{};  // where no track drives them
  std::vector<DrivenParameters> tracks = {};
  // The words are about the coordinate system under a fixed object, which is the inverse map.
  bool of_axes = false;
  CompositeTransform constant = {};  // of StepKind::fixed
};

class AnimatedTransform {
 public:
  AnimatedTransform& translate(Track offset);                                                         // width 3
  AnimatedTransform& scale_about(const glm::dvec3& point, Track factor);                              // width 3
  AnimatedTransform& rotate_about_axis(const glm::dvec3& from, const glm::dvec3& to, Track degrees);  // width 1
  AnimatedTransform& shear(Track factors);             // width 6: xy xz yx yz zx zy
  AnimatedTransform& fixed(CompositeTransform steps);  // steps that do not move
  // Error(usage) when a track is empty, one of rotations, or drives parameters that the kind does not have.
  AnimatedTransform& add_step(AnimatedStep step);

  // A pure function of the tick. Error(usage) when a parameter, moving or constant, is not finite or degenerate
  // (CompositeTransform says which are), or a step of the axes has no inverse.
  CompositeTransform at(std::int64_t tick) const;

  const std::vector<AnimatedStep>& steps() const { return steps_; }
  bool empty() const { return steps_.empty(); }
  bool moves() const;  // some step has a track

 private:
  AnimatedTransform& add(const char* name, AnimatedStep step, int first, int width, Track parameter);
  std::vector<AnimatedStep> steps_;
};

}  // namespace morphcl
#pragma GCC visibility pop
