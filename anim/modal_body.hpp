// An elastic object in closed form: in its modes' coordinates every motion is a scalar spring's.
//
// The equations are linear, so a mode's coordinate is the sum over the targets of what a spring of the mode's frequency
// and damping does that follows the target's weight, times the target's share in the mode. Nothing is stepped: the
// accuracy is that of anim/spring.hpp, at any stiffness. A frame costs modes x (tracks + masses).
#pragma once

#include <vector>

#include "anim/elastic_body.hpp"
#include "anim/spring_motion.hpp"
#include "anim/vibration_modes.hpp"

namespace morphcl {

class ModalBody : public ElasticBody {
 public:
  // The tracks of `drive` are no springs.
  ModalBody(const SpringNet& net, EdgeRest rest, MorphDrive drive, const TimeBase& time);
  void displacements_at(std::int64_t frame, Displacements& out) override;
  ElasticMethod method() const override { return ElasticMethod::modal; }

 private:
  struct Mode {
    std::vector<SpringMotion> motions;  // of each track, along this mode
    std::vector<glm::dvec3> shares;     // of each target
  };
  glm::dvec3 coordinate_at(const Mode& mode, std::int64_t tick);

  MorphDrive drive_;
  TimeBase time_;
  VibrationModes shapes_;
  std::vector<Mode> modes_;
  std::vector<double> weights_;  // of each target, as the mode at hand feels it
};

}  // namespace morphcl
