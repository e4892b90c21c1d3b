// Steps of a net of springs in time by TR-BDF2: second order, and stable however stiff the springs are.
//
// Method: Bank et al. (1985), as a Runge-Kutta method (Hosea and Shampine 1996): the trapezoidal rule to t + gamma h,
// gamma = 2 - sqrt 2, then the backward difference formula through both points; with this gamma both solve the same
// matrix, which is factored once. L-stable: of what oscillates too fast for the step nothing is left, where the
// trapezoidal rule rings. For these equations, whose energy falls, the step's energy never grows (von Neumann's
// inequality: |R(z)| <= 1 wherever Re z <= 0).
#pragma once

#include "anim/elastic.hpp"
#include "anim/stiffness_solver.hpp"

namespace morphcl {

struct NetState {
  Displacements position, velocity;  // of each mass
  bool operator==(const NetState&) const = default;
};

// How the net is driven: each mass to a place, which its anchor pulls to, and with EdgeRest::driven the edges too.
class TrBdf2 {
 public:
  // `net` outlives this. Errors: StiffnessSolver's.
  TrBdf2(const SpringNet& net, EdgeRest rest, double step_seconds);

  // One step, while the driven places move from `before` to `after` along straight lines.
  void step(NetState& state, const Displacements& before, const Displacements& after) const;

 private:
  // The acceleration without damping, K (driven - x) or anchor driven - K x.
  void pull(const Displacements& driven, const Displacements& x, Displacements& out) const;
  // v of: v = velocity + ch (pull(driven, position + ch v) - D v); then position += ch v.
  void solve_stage(const Displacements& driven, Displacements& position, Displacements& velocity) const;

  const SpringNet* net_;
  EdgeRest rest_;
  double ch_;  // (1 - sqrt(1/2)) h
  StiffnessSolver solver_;
};

}  // namespace morphcl
