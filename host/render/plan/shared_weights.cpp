#include "host/render/plan/shared_weights.hpp"

#include <map>

#include "anim/timeline_at.hpp"

namespace morphcl {

namespace {

bool same_weights(const MorphWeights& a, const MorphWeights& b) {
  return a.weights == b.weights && a.tracks == b.tracks;
}

}  // namespace

SharedWeights::SharedWeights(const Scene& scene) {
  std::map<int, std::uint32_t> last_of_mesh;
  values_of_.reserve(scene.objects.size());
  for (std::size_t object = 0; object < scene.objects.size(); ++object) {
    const MorphWeights& morph = scene.objects[object].morph;
    const auto [last, first_of_mesh] = last_of_mesh.emplace(scene.objects[object].mesh, 0u);
    if (first_of_mesh || !same_weights(*values_[last->second].morph, morph)) {
      last->second = static_cast<std::uint32_t>(values_.size());
      values_.push_back({&morph, {}});
    }
    values_of_.push_back(last->second);
  }
}

const std::vector<double>& SharedWeights::of(std::size_t object, std::int64_t tick) {
  Values& values = values_[values_of_[object]];
  if (values.known && values.tick == tick) return values.weights;
  values.known = false;
  evaluate_weights(*values.morph, tick, values.weights);
  values.tick = tick;
  values.known = true;
  return values.weights;
}

}  // namespace morphcl
