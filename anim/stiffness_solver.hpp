// Solves (identity_part I + stiffness_part K) x = b for a net of springs, once factored, as often as asked.
#pragma once

#include <memory>

#include "anim/spring_net.hpp"

namespace morphcl {

// Method: sparse LDL^T with a minimum-degree order (Eigen's SimplicialLDLT), then one step of iterative refinement with
// a residual that is computed spring by spring, which takes back what assembling the matrix rounded away. Plain loops
// in a fixed order: the same bits on every machine.
class StiffnessSolver {
 public:
  // `net` outlives this. Parts >= 0, not both 0. Error(bad_input) when the matrix is not positive definite in binary64.
  StiffnessSolver(const SpringNet& net, double identity_part, double stiffness_part);
  ~StiffnessSolver();
  StiffnessSolver(StiffnessSolver&&) noexcept;

  void solve(const Displacements& b, Displacements& x) const;

 private:
  struct Factors;
  void solve_assembled(const Displacements& b, Displacements& x) const;

  const SpringNet* net_;
  double identity_part_, stiffness_part_;
  std::unique_ptr<const Factors> factors_;
};

}  // namespace morphcl
