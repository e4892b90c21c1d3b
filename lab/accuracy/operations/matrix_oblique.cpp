// The shear of an oblique projection from the direction in which depth is drawn and the projectors' angle beta.
#include <cmath>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/projection.hpp"

namespace morphcl::accuracy {

namespace {

// Planes: direction and beta in degrees, binary32 numbers. Results: cot(beta) cos(direction), cot(beta) sin(direction).
using Shear = std::array<double, 2>;

template <class Real>
Shear naive_oblique(double direction_degrees, double beta_degrees) {
  constexpr Real degree = static_cast<Real>(3.14159265358979323846 / 180);
  const Real direction = static_cast<Real>(direction_degrees) * degree, beta = static_cast<Real>(beta_degrees) * degree;
  const Real factor = 1 / std::tan(beta);
  return {static_cast<double>(factor * std::cos(direction)), static_cast<double>(factor * std::sin(direction))};
}

Shear shipped_oblique_in_fp64(double direction_degrees, double beta_degrees) {
  const ObliqueShear shear = oblique_shear(direction_degrees, oblique_factor(beta_degrees));
  return {shear.x, shear.y};
}

Shear shipped_oblique_rounded(double direction_degrees, double beta_degrees) {
  const Shear shear = shipped_oblique_in_fp64(direction_degrees, beta_degrees);
  return {static_cast<float>(shear[0]), static_cast<float>(shear[1])};
}

}  // namespace

Operation matrix_oblique() {
  PlanarOperation<double> op;
  op.about = {.name = "matrix-oblique",
              .title = "building the shear of an oblique projection from its two angles",
              .results = "matrix entries",
              .format = binary32,
              .plotted = Measure::max_ulp,
              .target = 0.501,
              .reason = "each entry rounded to binary32 once"};
  op.results = 2;
  op.families = {
      binary32_family("benign", "directions from 0 to 360 degrees, beta from 30 to 89", 2,
                      [](Random& r, double* in) {
                        in[0] = r.uniform(0, 360);
                        in[1] = r.uniform(30, 89);
                      }),
      binary32_family("wide", "directions from -10^5 to 10^5 degrees, beta from 1 to 89", 2,
                      [](Random& r, double* in) {
                        in[0] = r.uniform(-1e5, 1e5);
                        in[1] = r.uniform(1, 89);
                      }),
      binary32_family("adversarial", "directions within 2^-20 to 2^-1 degrees of 90, beta as near below 90", 2,
                      [](Random& r, double* in) {
                        in[0] = 90 + r.binades(-20, -1);
                        in[1] = 90 - r.binades(-16, -1);
                      }),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const ExactSinCos<Number> direction = exact_sin_cos<Number>(in(0, i)), beta = exact_sin_cos<Number>(in(1, i));
    const Number factor = beta.cos / beta.sin;
    results[0].value = factor * direction.cos;
    results[1].value = factor * direction.sin;
    for (std::size_t r = 0; r < 2; ++r) results[r].magnitude = abs(results[r].value);
  });
  op.variants = {
      by_c_library(elementwise64<2>("fp32", inlined<naive_oblique<float>>)),
      by_c_library(elementwise64<2>("fp64, C library", inlined<naive_oblique<double>>)),
      shipped(elementwise64<2>("morphcl, rounded once", inlined<shipped_oblique_rounded>)),
      shipped(elementwise64<2>("morphcl in fp64", inlined<shipped_oblique_in_fp64>)),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
