// The matrix of a rotation about an axis of any length.
#include <cmath>
#include <glm/glm.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/matrix_entries.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/rotation.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::accuracy {

namespace {

template <class Real>
glm::mat<3, 3, Real> rows(Real a, Real b, Real c, Real d, Real e, Real f, Real g, Real h, Real i) {
  return glm::mat<3, 3, Real>(a, d, g, b, e, h, c, f, i);
}

// The textbook's seven steps without its two translations: the axis is turned onto z about x, then about y; the
// rotation about z; and back.
Entries3x3 chain_in_fp32(double x, double y, double z, double degrees) {
  const auto a = static_cast<float>(x), b = static_cast<float>(y), c = static_cast<float>(z);
  const float d = std::sqrt(b * b + c * c), length = std::sqrt(a * a + b * b + c * c);
  const float angle = static_cast<float>(degrees) * 3.14159265f / 180;
  const float sine = std::sin(angle), cosine = std::cos(angle);
  const auto about_x = rows<float>(1, 0, 0, 0, c / d, -b / d, 0, b / d, c / d);
  const auto about_y = rows<float>(d / length, 0, -a / length, 0, 1, 0, a / length, 0, d / length);
  const auto about_z = rows<float>(cosine, -sine, 0, sine, cosine, 0, 0, 0, 1);
  return entries_3x3(glm::transpose(about_x) * glm::transpose(about_y) * about_z * about_y * about_x);
}

template <class Real>
Entries3x3 rodrigues(double x, double y, double z, double degrees) {
  const glm::vec<3, Real> axis(x, y, z);
  const glm::vec<3, Real> n = axis / std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
  const Real angle = static_cast<Real>(degrees) * static_cast<Real>(3.14159265358979323846) / 180;
  const Real s = std::sin(angle), c = std::cos(angle), v = 1 - c;
  return entries_3x3(rows<Real>(c + v * n.x * n.x, v * n.x * n.y - s * n.z, v * n.x * n.z + s * n.y,  //
                                v * n.x * n.y + s * n.z, c + v * n.y * n.y, v * n.y * n.z - s * n.x,  //
                                v * n.x * n.z - s * n.y, v * n.y * n.z + s * n.x, c + v * n.z * n.z));
}

Entries3x3 shipped_rotation_in_fp64(double x, double y, double z, double degrees) {
  return entries_3x3(axis_rotation({x, y, z}, degrees).matrix);
}

Entries3x3 shipped_rotation_rounded(double x, double y, double z, double degrees) {
  return entries_3x3(to_fp32(axis_rotation({x, y, z}, degrees).matrix));
}

InputFamily rotation_family(const char* name, const char* text, auto fill) {
  return {name, text, [fill](Random& random, std::size_t count) { return drawn(random, 4, count, {}, fill); }};
}

}  // namespace

Operation matrix_rotation() {
  PlanarOperation<double> op;
  op.about = {.name = "matrix-rotation",
              .title = "building the matrix of a rotation about an axis",
              .results = "matrix entries",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 1.001,
              .reason = "one rounding to binary32 of entries up to 1"};
  op.results = 9;
  op.families = {
      rotation_family("benign", "axes of any direction and length 1/2 to 2, -180 to 180 degrees",
                      [](Random& r, double* in) {
                        for (int axis = 0; axis < 3; ++axis) in[axis] = r.uniform(-1, 1);
                        in[3] = r.uniform(-180, 180);
                      }),
      rotation_family("wide", "axes from 2^-60 to 2^60 long, components up to 2^20 apart, angles up to 10^6 degrees",
                      [](Random& r, double* in) {
                        const double size = r.binades(-60, 59);
                        for (int axis = 0; axis < 3; ++axis) in[axis] = size * r.signed_binades(-20, 0);
                        in[3] = r.uniform(-1e6, 1e6);
                      }),
      rotation_family("adversarial", "axes along x or within 2^-60 of it, multiples of 90 degrees or about 10^-4",
                      [](Random& r, double* in) {
                        in[0] = 1;
                        in[1] = r.signed_binades(-70, -61);
                        in[2] = r.signed_binades(-70, -61);
                        if (r.integer(0, 3) == 0) in[1] = in[2] = 0;
                        in[3] = r.integer(0, 1) == 0 ? 90 * r.integer(-4, 4) : r.uniform(0.5e-4, 2e-4);
                      }),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    std::array<Number, 3> n = {in(0, i), in(1, i), in(2, i)};
    const Number length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (Number& component : n) component /= length;
    const ExactSinCos<Number> angle = exact_sin_cos<Number>(in(3, i));
    const Number s = angle.sin, v = 1 - angle.cos;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column) {
        Number entry = v * n[row] * n[column];
        if (row == column) entry += 1 - v;
        if ((row + 2) % 3 == column) entry += s * n[(row + 1) % 3];
        if ((row + 1) % 3 == column) entry -= s * n[(row + 2) % 3];
        results[3 * row + column] = {entry, Number(1)};
      }
  });
  op.variants = {
      by_c_library(elementwise64<4>("seven steps in fp32", inlined<chain_in_fp32>)),
      by_c_library(elementwise64<4>("Rodrigues in fp32", inlined<rodrigues<float>>)),
      by_c_library(elementwise64<4>("Rodrigues in fp64, C library", inlined<rodrigues<double>>)),
      shipped(elementwise64<4>("morphcl, rounded once", inlined<shipped_rotation_rounded>)),
      shipped(elementwise64<4>("morphcl in fp64", inlined<shipped_rotation_in_fp64>)),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
