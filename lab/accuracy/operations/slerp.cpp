// Rotations between two keys: the spherical interpolation of quaternions.
#include <cmath>
#include <glm/glm.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "lab/accuracy/operations/quaternion_pairs.hpp"
#include "morphcl/rotation.hpp"

namespace morphcl::accuracy {

namespace {

using Quaternion = std::array<double, 4>;

// The textbook's formula, sin((1-t)a) / sin a and sin(ta) / sin a with a from acos, along the shorter arc.
template <class Real>
Quaternion naive_slerp(double ax, double ay, double az, double aw, double bx, double by, double bz, double bw,
                       double t64) {
  const std::array<Real, 4> a = {Real(ax), Real(ay), Real(az), Real(aw)};
  std::array<Real, 4> b = {Real(bx), Real(by), Real(bz), Real(bw)};
  const Real t = static_cast<Real>(t64);
  Real dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  if (dot < 0) {
    dot = -dot;
    for (Real& component : b) component = -component;
  }
  const Real angle = std::acos(dot), from = std::sin((1 - t) * angle) / std::sin(angle),
             to = std::sin(t * angle) / std::sin(angle);
  return {a[0] * from + b[0] * to, a[1] * from + b[1] * to, a[2] * from + b[2] * to, a[3] * from + b[3] * to};
}

Quaternion nlerp(double ax, double ay, double az, double aw, double bx, double by, double bz, double bw, double t) {
  const double sign = ax * bx + ay * by + az * bz + aw * bw < 0 ? -1 : 1;
  const auto mix = [&](double a, double b) { return (1 - t) * a + t * sign * b; };
  const double x = mix(ax, bx), y = mix(ay, by), z = mix(az, bz), w = mix(aw, bw);
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  return {x / length, y / length, z / length, w / length};
}

Quaternion shipped_slerp(double ax, double ay, double az, double aw, double bx, double by, double bz, double bw,
                         double t) {
  const glm::dquat q = slerp(glm::dquat(aw, ax, ay, az), glm::dquat(bw, bx, by, bz), t);
  return {q.x, q.y, q.z, q.w};
}

InputFamily slerp_family(const char* name, const char* text, int low, int high) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 9, count, {}, [=](Random& r, double* in) {
              draw_quaternion_pair(r, r.binades(low, high), in);
              in[8] = r.uniform(0, 1);
            });
          }};
}

}  // namespace

Operation slerp_rotation() {
  PlanarOperation<double> op;
  op.about = {.name = "slerp",
              .title = "the rotation between two keys",
              .results = "components of a unit quaternion",
              .format = binary32,
              .plotted = Measure::max_absolute,
              .target = 0x1p-23,
              .reason = "two roundings to binary32 of the components"};
  op.results = 4;
  op.families = {
      slerp_family("benign", "keys 1/2 to 2 radians apart (of the rotation)", -1, 0),
      slerp_family("wide", "keys 2^-20 to 2 radians apart", -20, 0),
      slerp_family("adversarial", "keys 2^-40 to 2^-12 radians apart", -40, -13),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    std::array<Number, 4> a, b;
    for (std::size_t k = 0; k < 4; ++k) {
      a[k] = in(k, i);
      b[k] = in(k + 4, i);
    }
    const Number angle = exact_angle(a, b), t = in(8, i), sine = sin(angle);
    const Number from = sin((1 - t) * angle) / sine, to = sin(t * angle) / sine;
    for (std::size_t k = 0; k < 4; ++k) results[k] = {a[k] * from + b[k] * to, Number(1)};
  });
  op.variants = {
      by_c_library(elementwise64<9>("acos and sin in fp32", inlined<naive_slerp<float>>)),
      by_c_library(elementwise64<9>("acos and sin in fp64", inlined<naive_slerp<double>>)),
      elementwise64<9>("nlerp", inlined<nlerp>),
      shipped(elementwise64<9>("sinc", inlined<shipped_slerp>)),
  };
  op.compared = 1024;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
