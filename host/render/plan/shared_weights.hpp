// The morph weights of objects at a tick, evaluated once for objects that morph alike: the copies of a crowd often do.
#pragma once

#include <cstdint>
#include <vector>

#include "morphcl/scene.hpp"

namespace morphcl {

class SharedWeights {
 public:
  // The scene outlives this. Objects share their weights with the one before of the same mesh if theirs are equal.
  explicit SharedWeights(const Scene& scene);

  // One weight a target; stands until the object is asked for at another tick. Errors as evaluate_weights() has them.
  const std::vector<double>& of(std::size_t object, std::int64_t tick);

 private:
  struct Values {
    const MorphWeights* morph;
    std::vector<double> weights;
    std::int64_t tick = 0;
    bool known = false;
  };
  std::vector<std::uint32_t> values_of_;  // an object: index into values_
  std::vector<Values> values_;
};

}  // namespace morphcl
