// The springs of elastic objects: struct Elastic is in morphcl/timeline.hpp.
#pragma once

#include "morphcl/timeline.hpp"

namespace morphcl {

// How a vertex swings that moves as its neighbours do: the slowest spring of the object.
Spring anchor_spring(const Elastic& elastic);

}  // namespace morphcl
