// The shapes in which a net of springs swings, each with a frequency of its own.
#pragma once

#include <cstddef>
#include <vector>

#include "anim/spring_net.hpp"

namespace morphcl {

// The eigenvectors of K, orthonormal, and its eigenvalues.
struct VibrationModes {
  std::vector<double> stiffness;  // omega^2 of each mode, 1/s^2; >= anchor
  std::vector<double> shapes;     // mode after mode, one number a mass
  std::size_t masses() const { return stiffness.size(); }
  const double* shape(std::size_t mode) const { return shapes.data() + mode * masses(); }
};

// O(n^2 (n + edges)): for small nets.
//
// K is never assembled. With B the matrix that has a column sqrt(k) (e_a - e_b) for every edge, K = anchor I + B B^T,
// so the singular values and left vectors of B give the modes. One-sided Jacobi rotations after two QR decompositions,
// the first with column pivoting, find also the small singular values with high relative accuracy, however much stiffer
// one edge is than another (Drmac and Veselic, New fast and accurate Jacobi SVD algorithm, 2008).
VibrationModes find_modes(const SpringNet& net);

}  // namespace morphcl
