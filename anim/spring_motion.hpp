// A mass on a spring that follows the keys of a track, as a pure function of the tick.
//
// Before the first key it rests at that key's value; between keys the track's rule moves the target; after the last key
// the target stays and the mass settles. The state at every key is computed once, by exact steps from key to key, so a
// tick costs one step whatever was asked for before.
#pragma once

#include <cstdint>
#include <vector>

#include "anim/spring.hpp"

namespace morphcl {

class Track;

class SpringMotion {
 public:
  // Linear in the keys of `target`, each of its components on its own. Of a rotation the four numbers are followed.
  SpringMotion(const Spring& spring, const Track& target);

  const Spring& spring() const { return spring_; }
  // Writes one position a component. `target` is the track it was made for. Finite unless the target is near the
  // largest double.
  void evaluate(const Track& target, std::int64_t tick, double* positions) const;

 private:
  Spring spring_;
  std::vector<SpringState> at_keys_;  // of each component, key after key
};

}  // namespace morphcl
