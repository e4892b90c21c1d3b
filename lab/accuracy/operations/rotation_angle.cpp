// The angle between two rotations.
#include <cmath>
#include <glm/glm.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "lab/accuracy/operations/quaternion_pairs.hpp"
#include "morphcl/rotation.hpp"

namespace morphcl::accuracy {

namespace {

template <class Real>
double angle_by_acos(double ax, double ay, double az, double aw, double bx, double by, double bz, double bw) {
  return static_cast<double>(
      std::acos(Real(ax) * Real(bx) + Real(ay) * Real(by) + Real(az) * Real(bz) + Real(aw) * Real(bw)));
}

// Kahan's: twice the arc tangent of |a - b| / |a + b|.
template <class Real>
double angle_by_atan2(double ax, double ay, double az, double aw, double bx, double by, double bz, double bw) {
  const auto square = [](Real x, Real y, Real z, Real w) { return x * x + y * y + z * z + w * w; };
  const Real a[4] = {Real(ax), Real(ay), Real(az), Real(aw)}, b[4] = {Real(bx), Real(by), Real(bz), Real(bw)};
  const Real apart = square(a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]);
  const Real together = square(a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]);
  return static_cast<double>(2 * std::atan2(std::sqrt(apart), std::sqrt(together)));
}

double shipped_angle(double ax, double ay, double az, double aw, double bx, double by, double bz, double bw) {
  return angle_between(glm::dquat(aw, ax, ay, az), glm::dquat(bw, bx, by, bz));
}

InputFamily rotation_angle_family(const char* name, const char* text, int low, int high) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 8, count, {},
                         [=](Random& r, double* in) { draw_quaternion_pair(r, r.binades(low, high), in); });
          }};
}

}  // namespace

Operation rotation_angle() {
  PlanarOperation<double> op;
  op.about = {.name = "rotation-angle",
              .title = "the angle between two rotations",
              .results = "radians",
              .format = binary64,
              .plotted = Measure::max_scaled,
              .target = 0x1p29,
              .reason = "a relative error of 2^-24"};
  op.families = {
      rotation_angle_family("benign", "1/2 to 2 radians apart", -1, 0),
      rotation_angle_family("wide", "2^-20 to 2 radians apart", -20, 0),
      rotation_angle_family("adversarial", "2^-40 to 2^-12 radians apart", -40, -13),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    std::array<Number, 4> a, b;
    for (std::size_t k = 0; k < 4; ++k) {
      a[k] = in(k, i);
      b[k] = in(k + 4, i);
    }
    result->value = result->magnitude = exact_angle(a, b);
  });
  op.variants = {
      by_c_library(elementwise64<8>("acos in fp32", inlined<angle_by_acos<float>>)),
      by_c_library(elementwise64<8>("acos in fp64", inlined<angle_by_acos<double>>)),
      by_c_library(elementwise64<8>("atan2 in fp64", inlined<angle_by_atan2<double>>)),
      shipped(elementwise64<8>("wedge product", inlined<shipped_angle>)),
  };
  op.compared = 1024;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
