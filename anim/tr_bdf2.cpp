#include "anim/tr_bdf2.hpp"

#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr double root_2 = 0x1.6a09e667f3bcdp+0;
constexpr double gamma = 2 - root_2, implicit_part = 1 - 0.5 * root_2;
constexpr double weight_0 = 0.5 * (root_2 - 1);  // of the backward difference formula

double identity_part(const SpringNet& net, double ch) { return 1 + ch * net.damping; }
double stiffness_part(const SpringNet& net, double ch) { return ch * (net.stiffness_damping + ch); }

}  // namespace

TrBdf2::TrBdf2(const SpringNet& net, EdgeRest rest, double step_seconds)
    : net_(&net),
      rest_(rest),
      ch_(implicit_part * step_seconds),
      solver_(net, identity_part(net, ch_), stiffness_part(net, ch_)) {}

void TrBdf2::pull(const Displacements& driven, const Displacements& x, Displacements& out) const {
  const std::size_t n = net_->masses;
  out.assign(n, glm::dvec3(0.0));
  if (rest_ == EdgeRest::driven) {
    Displacements strain(n);
    for (std::size_t i = 0; i < n; ++i) strain[i] = driven[i] - x[i];
    add_stiffness(*net_, strain, 1, out);
  } else {
    for (std::size_t i = 0; i < n; ++i) out[i] = net_->anchor * driven[i];
    add_stiffness(*net_, x, -1, out);
  }
}

void TrBdf2::solve_stage(const Displacements& driven, Displacements& position, Displacements& velocity) const {
  Displacements right;
  pull(driven, position, right);
  for (std::size_t i = 0; i < right.size(); ++i) right[i] = velocity[i] + ch_ * right[i];
  solver_.solve(right, velocity);
  for (std::size_t i = 0; i < right.size(); ++i) position[i] += ch_ * velocity[i];
}

void TrBdf2::step(NetState& state, const Displacements& before, const Displacements& after) const {
  const std::size_t n = net_->masses;
  // Trapezoidal rule to t + gamma h, gamma h / 2 = ch: half a step with the slope at the start, half with that at the
  // end.
  Displacements slope, driven(n);
  pull(before, state.position, slope);
  for (std::size_t i = 0; i < n; ++i) slope[i] -= net_->damping * state.velocity[i];
  add_stiffness(*net_, state.velocity, -net_->stiffness_damping, slope);
  NetState middle = state;
  for (std::size_t i = 0; i < n; ++i) {
    middle.position[i] += ch_ * state.velocity[i];
    middle.velocity[i] += ch_ * slope[i];
    for (int c = 0; c < 3; ++c) driven[i][c] = lerp(before[i][c], after[i][c], gamma);
  }
  solve_stage(driven, middle.position, middle.velocity);

  for (std::size_t i = 0; i < n; ++i) {
    // (1 + weight_0) middle - weight_0 state.
    state.position[i] = middle.position[i] + weight_0 * (middle.position[i] - state.position[i]);
    state.velocity[i] = middle.velocity[i] + weight_0 * (middle.velocity[i] - state.velocity[i]);
  }
  solve_stage(after, state.position, state.velocity);
}

}  // namespace morphcl
