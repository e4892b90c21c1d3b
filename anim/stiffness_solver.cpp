#include "anim/stiffness_solver.hpp"

#include <Eigen/SparseCholesky>
#include <vector>

#include "morphcl/error.hpp"

// The width of vectors must not decide the order of sums (anim/CMakeLists.txt).
#ifndef EIGEN_DONT_VECTORIZE
#error "compile with EIGEN_DONT_VECTORIZE"
#endif

namespace morphcl {

namespace {
using Matrix = Eigen::SparseMatrix<double>;
}

struct StiffnessSolver::Factors {
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt;
};

StiffnessSolver::StiffnessSolver(const SpringNet& net, double identity_part, double stiffness_part)
    : net_(&net), identity_part_(identity_part), stiffness_part_(stiffness_part) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(net.masses + 3 * net.edges.size());
  const auto add = [&entries](std::uint32_t row, std::uint32_t column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (std::uint32_t i = 0; i < net.masses; ++i) add(i, i, identity_part + stiffness_part * net.anchor);
  for (const SpringNet::Edge& edge : net.edges) {
    const double k = stiffness_part * edge.stiffness;
    add(edge.a, edge.a, k);
    add(edge.b, edge.b, k);
    add(std::max(edge.a, edge.b), std::min(edge.a, edge.b), -k);
  }
  const auto size = static_cast<Eigen::Index>(net.masses);
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  auto factors = std::make_unique<Factors>();
  factors->ldlt.compute(matrix);
  if (factors->ldlt.info() != Eigen::Success || !(factors->ldlt.vectorD().minCoeff() > 0))
    throw Error(ErrorKind::bad_input, "",
                "an elastic object's springs are too different to be solved; use stiffnesses nearer to the anchor's");
  factors_ = std::move(factors);
}

StiffnessSolver::~StiffnessSolver() = default;
StiffnessSolver::StiffnessSolver(StiffnessSolver&&) noexcept = default;

void StiffnessSolver::solve_assembled(const Displacements& b, Displacements& x) const {
  Eigen::VectorXd component(static_cast<Eigen::Index>(b.size()));
  for (int c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < b.size(); ++i) component[static_cast<Eigen::Index>(i)] = b[i][c];
    component = factors_->ldlt.solve(component).eval();
    for (std::size_t i = 0; i < b.size(); ++i) x[i][c] = component[static_cast<Eigen::Index>(i)];
  }
}

void StiffnessSolver::solve(const Displacements& b, Displacements& x) const {
  x.resize(b.size());
  solve_assembled(b, x);
  Displacements residual = b, correction(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) residual[i] -= identity_part_ * x[i];
  add_stiffness(*net_, x, -stiffness_part_, residual);
  solve_assembled(residual, correction);
  for (std::size_t i = 0; i < b.size(); ++i) x[i] += correction[i];
}

}  // namespace morphcl
