#include "lab/accuracy/operations/chain_integrators.hpp"

namespace morphcl::accuracy {

namespace {

constexpr double constant_damping = 2, stiffness_damping = 1e-8;

ChainVector combined(const ChainVector& a, double factor, const ChainVector& b) {
  ChainVector sum;
  for (std::size_t i = 0; i < chain_masses; ++i) sum[i] = a[i] + factor * b[i];
  return sum;
}

}  // namespace

double link_stiffness(std::size_t i) {
  constexpr double stiffness[chain_masses - 1] = {1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12};
  return stiffness[i];
}

ChainVector stiffness_times(const ChainVector& x) {
  ChainVector result = x;
  for (std::size_t i = 0; i + 1 < chain_masses; ++i) {
    const double pull = link_stiffness(i) * (x[i] - x[i + 1]);
    result[i] += pull;
    result[i + 1] -= pull;
  }
  return result;
}

ChainIntegrator::ChainIntegrator(double step, double implicit_part) : h_(step), s_(implicit_part * step) {
  const double diagonal = 1 + s_ * constant_damping, scale = s_ * stiffness_damping + s_ * s_;
  for (std::size_t column = 0; column < chain_masses; ++column) {
    ChainVector unit{};
    unit[column] = 1;
    const ChainVector k = stiffness_times(unit);
    for (std::size_t row = 0; row < chain_masses; ++row)
      factor_[row][column] = (row == column ? diagonal : 0) + scale * k[row];
  }
  for (std::size_t j = 0; j < chain_masses; ++j)
    for (std::size_t i = j + 1; i < chain_masses; ++i) {
      const double l = factor_[i][j] / factor_[j][j];
      for (std::size_t k = j + 1; k <= i; ++k) factor_[i][k] -= l * factor_[k][j];
      factor_[i][j] = l * factor_[j][j];
    }
}

ChainVector ChainIntegrator::force(const ChainMotion& m, const ChainVector& g) const {
  const ChainVector pull = stiffness_times(combined(m.x, stiffness_damping, m.v));
  ChainVector result;
  for (std::size_t i = 0; i < chain_masses; ++i) result[i] = g[i] - pull[i] - constant_damping * m.v[i];
  return result;
}

ChainMotion ChainIntegrator::solve(const ChainMotion& known, const ChainVector& g) const {
  // (1 + s D + s^2 K) v = v_known + s (g - K x_known)
  const ChainVector pull = stiffness_times(known.x);
  ChainVector v;
  for (std::size_t i = 0; i < chain_masses; ++i) v[i] = known.v[i] + s_ * (g[i] - pull[i]);
  for (std::size_t i = 0; i < chain_masses; ++i)
    for (std::size_t j = 0; j < i; ++j) v[i] -= factor_[i][j] / factor_[j][j] * v[j];
  for (std::size_t i = chain_masses; i-- > 0;) {
    for (std::size_t j = i + 1; j < chain_masses; ++j) v[i] -= factor_[j][i] * v[j];
    v[i] /= factor_[i][i];
  }
  return {combined(known.x, s_, v), v};
}

void ChainSymplecticEuler::step(ChainMotion& m, const ChainVector& g0, const ChainVector&) {
  m.v = combined(m.v, h_, force(m, g0));
  m.x = combined(m.x, h_, m.v);
}

void ChainImplicitEuler::step(ChainMotion& m, const ChainVector&, const ChainVector& g1) { m = solve(m, g1); }

void ChainTrapezoidal::step(ChainMotion& m, const ChainVector& g0, const ChainVector& g1) {
  m = solve({combined(m.x, s_, m.v), combined(m.v, s_, force(m, g0))}, g1);
}

void ChainBdf2::step(ChainMotion& m, const ChainVector&, const ChainVector& g1) {
  ChainMotion known;
  for (std::size_t i = 0; i < chain_masses; ++i) {
    known.x[i] = (4 * m.x[i] - before_.x[i]) / 3;
    known.v[i] = (4 * m.v[i] - before_.v[i]) / 3;
  }
  before_ = m;
  m = solve(known, g1);
}

}  // namespace morphcl::accuracy
