// What anim/spring.hpp is judged by: the same motion by the Taylor series of its differential equation, in many digits.
#pragma once

#include "anim/spring.hpp"
#include "tests/math/reference.hpp"

namespace morphcl::reference {

struct ExactState {
  Exact position, velocity;
};

// After `seconds`, exactly the given doubles: [x, v, 1, t, t^2, t^3] obeys a linear equation with a constant matrix,
// whose exponential is taken by halving the time until the Taylor series converges fast, and squaring. 300 decimal
// digits: the squarings may lose one for each halving, and stiff springs need up to 70 of them.
ExactState spring_state(const Spring& spring, const SpringState& from, const Cubic& target, double seconds);

}  // namespace morphcl::reference
