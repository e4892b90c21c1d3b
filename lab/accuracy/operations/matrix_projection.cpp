// The depth row of a perspective matrix, and where it takes points: forward with a far plane, and reversed.
#include <cmath>
#include <glm/glm.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::accuracy {

namespace {

// x scale, y scale, and z_clip = scale * z_eye + offset: planes are fovy in degrees, near and far; aspect is 16/9.
using ProjectionEntries = std::array<double, 4>;
constexpr double aspect = 16.0 / 9;

template <class Real>
ProjectionEntries naive_projection(double fovy_degrees, double near, double far) {
  const Real n = static_cast<Real>(near), f = static_cast<Real>(far);
  const Real half = static_cast<Real>(fovy_degrees) * static_cast<Real>(3.14159265358979323846) / 360;
  const Real cotangent = 1 / std::tan(half);
  return {static_cast<double>(cotangent / static_cast<Real>(aspect)), static_cast<double>(cotangent),
          static_cast<double>((f + n) / (n - f)), static_cast<double>(2 * f * n / (n - f))};
}

template <class Real>
ProjectionEntries projection_entries(const glm::mat<4, 4, Real>& m) {
  return {static_cast<double>(m[0][0]), static_cast<double>(m[1][1]), static_cast<double>(m[2][2]),
          static_cast<double>(m[3][2])};
}

ProjectionEntries shipped_projection_in_fp64(double fovy_degrees, double near, double far) {
  return projection_entries(projection_matrix(Perspective{fovy_degrees, near, far}, aspect));
}

ProjectionEntries shipped_projection_rounded(double fovy_degrees, double near, double far) {
  return projection_entries(to_fp32(projection_matrix(Perspective{fovy_degrees, near, far}, aspect)));
}

InputFamily projection_family(const char* name, const char* text, double low_fovy, double high_fovy, int near_low,
                              int near_high, int ratio_low, int ratio_high) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 3, count, {}, [=](Random& r, double* in) {
              in[0] = r.uniform(low_fovy, high_fovy);
              in[1] = static_cast<float>(r.binades(near_low, near_high));
              in[2] = static_cast<float>(in[1] * r.binades(ratio_low, ratio_high));
            });
          }};
}

}  // namespace

Operation matrix_projection() {
  PlanarOperation<double> op;
  op.about = {.name = "matrix-projection",
              .title = "building a perspective matrix from the field of view, near and far",
              .results = "matrix entries",
              .format = binary32,
              .plotted = Measure::max_ulp,
              .target = 0.501,
              .reason = "each entry rounded to binary32 once"};
  op.results = 4;
  op.families = {
      projection_family("benign", "20 to 90 degrees, near from 1/16 to 1, far / near from 16 to 4096", 20, 90, -4, -1,
                        4, 11),
      projection_family("wide", "1 to 170 degrees, near from 2^-20 to 2^20, far / near from 2 to 2^30", 1, 170, -20, 19,
                        1, 29),
      projection_family("adversarial", "10^-5 to 0.1 degrees; far * near overflows binary32", 1e-5, 0.1, 30, 40, 60,
                        80),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const ExactSinCos<Number> half = exact_sin_cos<Number>(0.5 * in(0, i));
    const Number cotangent = half.cos / half.sin, n = in(1, i), f = in(2, i);
    results[0].value = cotangent / aspect;
    results[1].value = cotangent;
    results[2].value = (f + n) / (n - f);
    results[3].value = 2 * f * n / (n - f);
    for (std::size_t r = 0; r < 4; ++r) results[r].magnitude = abs(results[r].value);
  });
  op.variants = {
      by_c_library(elementwise64<3>("fp32", inlined<naive_projection<float>>)),
      by_c_library(elementwise64<3>("fp64, C library", inlined<naive_projection<double>>)),
      shipped(elementwise64<3>("morphcl, rounded once", inlined<shipped_projection_rounded>)),
      shipped(elementwise64<3>("morphcl in fp64", inlined<shipped_projection_in_fp64>)),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
