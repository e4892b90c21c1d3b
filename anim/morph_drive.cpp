#include "anim/morph_drive.hpp"

#include <algorithm>
#include <limits>

#include "anim/timeline_at.hpp"

namespace morphcl {

void MorphDrive::displacements_at(std::int64_t tick, Displacements& out) const {
  std::vector<double> at;
  evaluate_weights(weights, tick, at);
  std::fill(out.begin(), out.end(), glm::dvec3(0.0));
  for (std::size_t t = 0; t < targets.size(); ++t) {
    if (at[t] == 0) continue;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += at[t] * targets[t][i];
  }
}

std::int64_t MorphDrive::first_tick() const {
  std::int64_t first = std::numeric_limits<std::int64_t>::max();
  for (const WeightTrack& driven : weights.tracks)
    if (!driven.track.empty()) first = std::min(first, driven.track.first_tick());
  return first;
}

std::int64_t MorphDrive::end_tick() const {
  std::int64_t end = std::numeric_limits<std::int64_t>::min();
  for (const WeightTrack& driven : weights.tracks)
    if (!driven.track.empty()) end = std::max(end, driven.track.end_tick());
  return end;
}

bool MorphDrive::on_springs() const {
  return std::any_of(weights.tracks.begin(), weights.tracks.end(),
                     [](const WeightTrack& driven) { return driven.track.interpolation() == Interpolation::spring; });
}

}  // namespace morphcl
