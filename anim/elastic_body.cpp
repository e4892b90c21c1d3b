#include "anim/elastic_body.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "anim/modal_body.hpp"
#include "anim/stepped_body.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

ElasticMethod choose_method(const SpringNet& net, const MorphDrive& drive) {
  if (net.masses > max_modal_masses) return ElasticMethod::tr_bdf2;
  std::size_t states = 0;
  for (const WeightTrack& driven : drive.weights.tracks) {
    if (driven.track.empty()) continue;
    if (driven.track.interpolation() == Interpolation::spring) return ElasticMethod::tr_bdf2;
    states += net.masses * driven.track.key_count() * static_cast<std::size_t>(driven.track.width());
  }
  return states > max_modal_key_states ? ElasticMethod::tr_bdf2 : ElasticMethod::modal;
}

std::unique_ptr<ElasticBody> make_elastic_body(SpringNet net, EdgeRest rest, MorphDrive drive, const TimeBase& time) {
  if (net.masses > max_elastic_masses)
    throw Error(
        ErrorKind::bad_input, "",
        fmt::format("an elastic object of {} different vertices; {} are possible", net.masses, max_elastic_masses));
  if (choose_method(net, drive) == ElasticMethod::modal)
    return std::make_unique<ModalBody>(net, rest, std::move(drive), time);
  return std::make_unique<SteppedBody>(std::move(net), rest, std::move(drive), time);
}

}  // namespace morphcl
