// Where an object is, in words and numbers.
#pragma once

#include <string>

#include "anim/node_sampler.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::cli {

// Its matrix to the world at the sampler's tick, taken apart: "at (1, 0, 0), turned 30 degrees about (0, 1, 0), scaled
// (2, 2, 2); put together again within 1e-16". What does nothing is left out.
std::string describe_placement(const Object& object, NodeSampler& nodes);

}  // namespace morphcl::cli
