#include "anim/modal_body.hpp"

#include <cmath>
#include <utility>

#include "host/math/finite.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

Spring spring_of_mode(const SpringNet& net, double stiffness) {
  const double omega = std::sqrt(stiffness);
  return {omega, 0.5 * (net.damping / omega + net.stiffness_damping * omega)};
}

glm::dvec3 share_of(const double* shape, const Displacements& target) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < target.size(); ++i) sum += shape[i] * target[i];
  return sum;
}

}  // namespace

ModalBody::ModalBody(const SpringNet& net, EdgeRest rest, MorphDrive drive, const TimeBase& time)
    : drive_(std::move(drive)), time_(time), shapes_(find_modes(net)), modes_(net.masses) {
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const double stiffness = shapes_.stiffness[m];
    // Edges that keep the base mesh hold the mode back: only its anchors pull it to the target.
    const double gain = rest == EdgeRest::driven ? 1 : net.anchor / stiffness;
    for (const Displacements& target : drive_.targets)
      modes_[m].shares.push_back(gain * share_of(shapes_.shape(m), target));
    for (const WeightTrack& driven : drive_.weights.tracks)
      if (!driven.track.empty()) modes_[m].motions.emplace_back(spring_of_mode(net, stiffness), driven.track);
  }
}

glm::dvec3 ModalBody::coordinate_at(const Mode& mode, std::int64_t tick) {
  weights_ = drive_.weights.weights;
  std::size_t motion = 0;
  for (const WeightTrack& driven : drive_.weights.tracks)
    if (!driven.track.empty()) mode.motions[motion++].evaluate(driven.track, tick, &weights_[driven.first_target]);
  glm::dvec3 sum(0.0);
  for (std::size_t t = 0; t < mode.shares.size(); ++t) sum += weights_[t] * mode.shares[t];
  return sum;
}

void ModalBody::displacements_at(std::int64_t frame, Displacements& out) {
  const std::int64_t tick = time_.frame_ticks(frame);
  out.assign(modes_.size(), glm::dvec3(0.0));
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const glm::dvec3 coordinate = coordinate_at(modes_[m], tick);
    if (!is_finite(coordinate))
      throw Error(ErrorKind::bad_input, "", "the elastic motion overflows; use smaller weights");
    const double* const shape = shapes_.shape(m);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += shape[i] * coordinate;
  }
}

}  // namespace morphcl
