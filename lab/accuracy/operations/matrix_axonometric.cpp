// The direction and the up vector of an axonometric view from azimuth and elevation.
#include <cmath>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/camera.hpp"

namespace morphcl::accuracy {

namespace {

// Planes: azimuth and elevation in degrees, binary32 numbers. Results: towards the eye, then up.
using View = std::array<double, 6>;

template <class Real>
View naive_axonometric(double azimuth_degrees, double elevation_degrees) {
  constexpr Real degree = static_cast<Real>(3.14159265358979323846 / 180);
  const Real azimuth = static_cast<Real>(azimuth_degrees) * degree;
  const Real elevation = static_cast<Real>(elevation_degrees) * degree;
  const Real sa = std::sin(azimuth), ca = std::cos(azimuth), se = std::sin(elevation), ce = std::cos(elevation);
  return {static_cast<double>(ce * sa),  static_cast<double>(se), static_cast<double>(ce * ca),
          static_cast<double>(-se * sa), static_cast<double>(ce), static_cast<double>(-se * ca)};
}

View shipped_axonometric_in_fp64(double azimuth_degrees, double elevation_degrees) {
  const ViewDirection view = view_from_angles(azimuth_degrees, elevation_degrees);
  return {view.towards_eye.x, view.towards_eye.y, view.towards_eye.z, view.up.x, view.up.y, view.up.z};
}

View shipped_axonometric_rounded(double azimuth_degrees, double elevation_degrees) {
  View view = shipped_axonometric_in_fp64(azimuth_degrees, elevation_degrees);
  for (double& component : view) component = static_cast<float>(component);
  return view;
}

}  // namespace

Operation matrix_axonometric() {
  PlanarOperation<double> op;
  op.about = {.name = "matrix-axonometric",
              .title = "building an axonometric view from azimuth and elevation",
              .results = "components",
              .format = binary32,
              .plotted = Measure::max_ulp,
              .target = 0.501,
              .reason = "each component rounded to binary32 once"};
  op.results = 6;
  op.families = {
      binary32_family("benign", "azimuth from -180 to 180 degrees, elevation from -90 to 90", 2,
                      [](Random& r, double* in) {
                        in[0] = r.uniform(-180, 180);
                        in[1] = r.uniform(-90, 90);
                      }),
      binary32_family("wide", "azimuth from -10^6 to 10^6 degrees", 2,
                      [](Random& r, double* in) {
                        in[0] = r.uniform(-1e6, 1e6);
                        in[1] = r.uniform(-90, 90);
                      }),
      binary32_family("adversarial", "azimuth within 2^-16 to 2^-1 degrees of 180, elevation as near below 90", 2,
                      [](Random& r, double* in) {
                        in[0] = 180 - r.binades(-16, -1);
                        in[1] = 90 - r.binades(-16, -1);
                      }),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const ExactSinCos<Number> azimuth = exact_sin_cos<Number>(in(0, i)), elevation = exact_sin_cos<Number>(in(1, i));
    results[0].value = elevation.cos * azimuth.sin;
    results[1].value = elevation.sin;
    results[2].value = elevation.cos * azimuth.cos;
    results[3].value = -elevation.sin * azimuth.sin;
    results[4].value = elevation.cos;
    results[5].value = -elevation.sin * azimuth.cos;
    for (std::size_t r = 0; r < 6; ++r) results[r].magnitude = abs(results[r].value);
  });
  op.variants = {
      by_c_library(elementwise64<2>("fp32", inlined<naive_axonometric<float>>)),
      by_c_library(elementwise64<2>("fp64, C library", inlined<naive_axonometric<double>>)),
      shipped(elementwise64<2>("morphcl, rounded once", inlined<shipped_axonometric_rounded>)),
      shipped(elementwise64<2>("morphcl in fp64", inlined<shipped_axonometric_in_fp64>)),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
