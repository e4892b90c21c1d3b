// A damped spring that follows a target, exactly:  x'' + 2 zeta omega x' + omega^2 (x - g(t)) = 0,  g a cubic.
//
// A step of any length is one linear map, so stiffness sets no limit to it: stable and accurate for omega t from 0 to
// 1e12 and beyond, every damping ratio from 0, through critical damping. Error: a few u = 2^-53 of the largest of |x0|,
// |g_i| t^i and what the velocity reaches, times 1 + omega_d t for the phase of the oscillation; the tests have the
// bound.
//
// Method: the solution is x0 p11 + v0 p12 + sum g_i r_i, where p11 and p12 are the free motions from a unit
// displacement and a unit velocity and r_i is the response from rest to g = t^i. Four ways to compute them, each free
// of cancellation in its region:
//   series      omega t < 1: p12 = t sum b_n by its Taylor series; r_i is its (i+1)-fold integral, term by term
//   oscillating |d| t >= 1/2: exp, sin, cos (or exp, expm1) with d^2 = omega^2 (1 - zeta)(1 + zeta)
//   critical    |d| t < 1/2: sin(dt)/d and cos(dt) as series in (dt)^2, one formula for both signs
//   cascade     zeta > 1.15: two lags in a row with rates omega^2/(a+d) and a+d; their responses are phi functions
#pragma once

#include <array>

#include "morphcl/track.hpp"

namespace morphcl {

struct SpringState {
  double position = 0, velocity = 0;  // velocity per second
};

// The map from a state to the state `seconds` later, for one spring; seconds >= 0.
class SpringStep {
 public:
  SpringStep(const Spring& spring, double seconds);
  SpringState apply(const SpringState& from, const Cubic& target) const;

 private:
  void find_by_series(const Spring& spring, double t);
  void find_by_oscillation(const Spring& spring, double t);
  void find_by_cascade(const Spring& spring, double t);

  double omega_squared_;
  double p11_ = 1, p12_ = 0, p22_ = 1;  // free motion; p22 is the velocity from a unit velocity
  std::array<double, 4> response_{};    // r_i, the position from rest after following t^i
};

// After how many seconds a step of the target has died down to a thousandth, about; at most 10, which a spring with
// little damping may need more than.
double settling_seconds(const Spring& spring);

// The largest factor by which the spring, at rest at first, can leave a range that its target stays in: the integral of
// |impulse response|, coth(pi zeta / (2 sqrt(1 - zeta^2))); 1 from critical damping on, infinite without damping.
double largest_overshoot(double damping_ratio);

}  // namespace morphcl
