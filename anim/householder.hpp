// QR decomposition by Householder reflections.
#pragma once

#include <cstddef>
#include <vector>

namespace morphcl {

// Column after column.
struct DenseMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;
  DenseMatrix(std::size_t r, std::size_t c) : rows(r), columns(c), values(r * c) {}
  double* column(std::size_t c) { return values.data() + c * rows; }
  const double* column(std::size_t c) const { return values.data() + c * rows; }
};

enum class Pivoting { none, columns };

// A P = Q R. `a` becomes R, upper trapezoidal; its columns change places with Pivoting::columns, the longest rest first
// (which place each came from is not kept). The reflections that make up Q, first to last, are returned.
class HouseholderQr {
 public:
  HouseholderQr(DenseMatrix& a, Pivoting pivoting);
  void apply_q(double* x) const;  // x <- Q x; as many numbers as `a` had rows

 private:
  std::vector<std::vector<double>> reflections_;  // vector i acts on rows i and below; of length sqrt(2), or empty
};

}  // namespace morphcl
