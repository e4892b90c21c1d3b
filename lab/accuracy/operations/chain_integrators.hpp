// A chain of eight masses whose springs grow stiffer by a factor of 100 from link to link, up to 10^12 times the first:
//   x'' = g(t) - K x - D x',  K = 1 + sum of 10^(2i) (e_i - e_i+1)(e_i - e_i+1)^T,  D = 2 + 10^-8 K
// and the integrators that such chains are usually simulated by.
#pragma once

#include <array>

namespace morphcl::accuracy {

constexpr std::size_t chain_masses = 8;
using ChainVector = std::array<double, chain_masses>;

struct ChainMotion {
  ChainVector x{}, v{};
};

// 10^(2i), the stiffness of the link between masses i and i + 1.
double link_stiffness(std::size_t i);

// K x, link by link: no assembled matrix, in which the stiffest springs would round the softest away.
ChainVector stiffness_times(const ChainVector& x);

class ChainIntegrator {
 public:
  // `implicit_part`: the fraction of the step in the matrix that is factored, 0 for explicit methods.
  ChainIntegrator(double step, double implicit_part);

 protected:
  ChainVector force(const ChainMotion& m, const ChainVector& g) const;
  // The solution of y = known + s f(y) for s = implicit_part * step.
  ChainMotion solve(const ChainMotion& known, const ChainVector& g) const;

  double h_, s_;

 private:
  std::array<ChainVector, chain_masses> factor_{};  // lower triangle of L D L^T of 1 + s D + s^2 K
};

struct ChainSymplecticEuler : ChainIntegrator {
  explicit ChainSymplecticEuler(double step) : ChainIntegrator(step, 0) {}
  void step(ChainMotion& m, const ChainVector& g0, const ChainVector& g1);
};

struct ChainImplicitEuler : ChainIntegrator {
  explicit ChainImplicitEuler(double step) : ChainIntegrator(step, 1) {}
  void step(ChainMotion& m, const ChainVector& g0, const ChainVector& g1);
};

struct ChainTrapezoidal : ChainIntegrator {
  explicit ChainTrapezoidal(double step) : ChainIntegrator(step, 0.5) {}
  void step(ChainMotion& m, const ChainVector& g0, const ChainVector& g1);
};

// The history before the first step is rest, as the chain has been.
struct ChainBdf2 : ChainIntegrator {
  explicit ChainBdf2(double step) : ChainIntegrator(step, 2.0 / 3) {}
  void step(ChainMotion& m, const ChainVector& g0, const ChainVector& g1);

 private:
  ChainMotion before_;
};

}  // namespace morphcl::accuracy
