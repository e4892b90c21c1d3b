// Where the many objects of a benchmark scene are. The same count gives the same places everywhere.
#pragma once

#include <vector>

#include "bench/scenes.hpp"

namespace morphcl::bench {

// In a box of half-edge 20 around the eye at the origin, turned any way, half-edges from 0.1 to 0.4.
std::vector<Placement> scattered(int count);

// As scattered(), but the first of every hundred is wholly in the view along -z, and the others are wholly outside of
// it. `aspect`: width / height of the picture. `only_in_view`: just the first of every hundred, where crowd() has them.
std::vector<Placement> crowd(int count, double aspect, bool only_in_view);

}  // namespace morphcl::bench
