// The inverse of a shear: its matrix is its six factors, exactly, but what undoes it has to be computed.
#include <cmath>
#include <glm/glm.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/matrix_entries.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::accuracy {

namespace {

// Planes: the factors xy, xz, yx, yz, zx, zy, binary32 numbers. Results: the inverse, row after row.
template <class Real>
Entries3x3 cofactors(double xy, double xz, double yx, double yz, double zx, double zy) {
  using Column = glm::vec<3, Real>;
  return entries_3x3(glm::inverse(glm::mat<3, 3, Real>(Column(1, yx, zx), Column(xy, 1, zy), Column(xz, yz, 1))));
}

glm::dmat4 inverse_of(double xy, double xz, double yx, double yz, double zx, double zy) {
  return CompositeTransform().shear(xy, xz, yx, yz, zx, zy).inverse().matrix();
}

Entries3x3 shipped_shear_in_fp64(double xy, double xz, double yx, double yz, double zx, double zy) {
  return entries_3x3(inverse_of(xy, xz, yx, yz, zx, zy));
}

Entries3x3 shipped_shear_rounded(double xy, double xz, double yx, double yz, double zx, double zy) {
  return entries_3x3(to_fp32(inverse_of(xy, xz, yx, yz, zx, zy)));
}

template <class Number>
using ExactMatrix = std::array<std::array<Number, 3>, 3>;  // rows

template <class Number>
ExactMatrix<Number> magnitudes(const ExactMatrix<Number>& a) {
  ExactMatrix<Number> m;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) m[row][column] = abs(a[row][column]);
  return m;
}

template <class Number>
ExactMatrix<Number> product(const ExactMatrix<Number>& a, const ExactMatrix<Number>& b) {
  ExactMatrix<Number> m;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      m[row][column] = a[row][0] * b[0][column] + a[row][1] * b[1][column] + a[row][2] * b[2][column];
  return m;
}

// The cofactor of (row, column) is a difference of two products of the other rows and columns, in cyclic order.
template <class Number>
ExactMatrix<Number> inverse(const ExactMatrix<Number>& a) {
  ExactMatrix<Number> m;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      const std::size_t r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
      m[column][row] = a[r1][c1] * a[r2][c2] - a[r1][c2] * a[r2][c1];
    }
  const Number determinant = a[0][0] * m[0][0] + a[0][1] * m[1][0] + a[0][2] * m[2][0];
  for (auto& row : m)
    for (Number& entry : row) entry /= determinant;
  return m;
}

}  // namespace

Operation matrix_shear() {
  PlanarOperation<double> op;
  op.about = {.name = "matrix-shear",
              .title = "the inverse of a shear by six factors",
              .results = "matrix entries",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 1,
              .reason = "half an ulp of |A^-1| |A| |A^-1|: rounding the factors costs as much"};
  op.results = 9;
  op.families = {
      binary32_family("benign", "factors from -1/4 to 1/4", 6,
                      [](Random& r, double* in) {
                        for (int factor = 0; factor < 6; ++factor) in[factor] = r.uniform(-0.25, 0.25);
                      }),
      binary32_family("wide", "factors of 2^-20 to 2^10", 6,
                      [](Random& r, double* in) {
                        for (int factor = 0; factor < 6; ++factor) in[factor] = r.binades(-20, 9);
                      }),
      binary32_family("adversarial", "xy yx within 2^-18 to 2^-8 of 1, the others about 2^-12", 6,
                      [](Random& r, double* in) {
                        in[0] = r.uniform(0.5, 2);
                        in[2] = (1 - r.binades(-18, -9)) / in[0];
                        for (const int factor : {1, 3, 4, 5}) in[factor] = r.binades(-13, -12);
                      }),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const auto factor = [&](std::size_t plane) { return Number(in(plane, i)); };
    const ExactMatrix<Number> shear = {
        {{Number(1), factor(0), factor(1)}, {factor(2), Number(1), factor(3)}, {factor(4), factor(5), Number(1)}}};
    const ExactMatrix<Number> exact = inverse(shear), positive = magnitudes(exact);
    const ExactMatrix<Number> condition = product(product(positive, magnitudes(shear)), positive);
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        results[3 * row + column] = {exact[row][column], condition[row][column]};
  });
  op.variants = {
      elementwise64<6>("fp32 cofactors", inlined<cofactors<float>>),
      elementwise64<6>("fp64 cofactors", inlined<cofactors<double>>),
      shipped(elementwise64<6>("morphcl, rounded once", inlined<shipped_shear_rounded>)),
      shipped(elementwise64<6>("morphcl in fp64", inlined<shipped_shear_in_fp64>)),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
