#include "anim/spring_motion.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "morphcl/track.hpp"

namespace morphcl {

SpringMotion::SpringMotion(const Spring& spring, const Track& target) : spring_(spring) {
  const auto width = static_cast<std::size_t>(target.width());
  at_keys_.reserve(target.key_count() * width);
  for (int i = 0; i < target.width(); ++i) at_keys_.push_back({target.key_value(0)[i], 0});
  std::optional<SpringStep> step;
  double seconds = 0;
  for (std::size_t key = 0; key + 1 < target.key_count(); ++key) {
    const double length = target.seconds_from_key(key, target.key_tick(key + 1));
    if (!step || length != seconds) step.emplace(spring, length);  // keys are often as far apart as those before
    seconds = length;
    for (int i = 0; i < target.width(); ++i)
      at_keys_.push_back(step->apply(at_keys_[key * width + static_cast<std::size_t>(i)], target.curve_from(key, i)));
  }
}

void SpringMotion::evaluate(const Track& target, std::int64_t tick, double* positions) const {
  const std::size_t key = target.key_before(tick);
  const SpringState* from = at_keys_.data() + key * static_cast<std::size_t>(target.width());
  if (tick <= target.key_tick(key)) {
    for (int i = 0; i < target.width(); ++i) positions[i] = from[i].position;
    return;
  }
  const SpringStep step(spring_, target.seconds_from_key(key, tick));
  for (int i = 0; i < target.width(); ++i) positions[i] = step.apply(from[i], target.curve_from(key, i)).position;
}

}  // namespace morphcl
