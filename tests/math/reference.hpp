// The exact answers that host/math and anim are judged by: the defining formulas, evaluated with 168 bits (Boost's
// cpp_bin_float) for exactly the given doubles. It shares no code with what it judges.
//
// An answer is handed over as the unevaluated sum of two doubles, 106 bits, so that no test needs the heavy headers.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

namespace morphcl::reference {

constexpr double u32 = 0x1p-24, u64 = 0x1p-53;  // half an ulp of 1 in fp32 and fp64
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Exact {
  double high = 0, low = 0;
  double error_of(double computed) const { return (computed - high) - low; }
};

// The distance of `computed` from the exact value in ulp of the exact value's binade.
double error_in_ulp(double computed, const Exact& exact);

struct ExactSinCos {
  Exact sin, cos;
};
ExactSinCos sin_cos_degrees(double degrees);
Exact radians(double degrees);
Exact degrees(double radians);
Exact decimal(const std::string& digits);  // "0.7816..." or "1000/17"

// Rows of 3 x 4 affine maps.
using Affine = std::array<std::array<Exact, 4>, 3>;
Affine rotation_about_line(const glm::dvec3& from, const glm::dvec3& to, double degrees);
Affine look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);
Affine inverse(const glm::dmat4& affine);
Affine product(const std::vector<glm::dmat4>& factors);  // the last one leftmost

// a * b - c * d.
Exact difference_of_products(double a, double b, double c, double d);

// The rows of a perspective matrix that are not plain: x scale, x shift, depth scale, depth offset.
struct PerspectiveEntries {
  Exact x_scale, x_shift, depth_scale, depth_offset;
};
PerspectiveEntries frustum(double left, double right, double near, double far);
Exact cotangent_of_half(double degrees);
Exact fovy_from_fovx(double fovx_degrees, double aspect);

// Quaternions as x y z w; they need not have unit length.
using Quaternion = std::array<double, 4>;
std::array<Exact, 4> slerp(const Quaternion& a, const Quaternion& b, double t);
Exact angle_between(const Quaternion& a, const Quaternion& b);
std::array<std::array<Exact, 3>, 3> rotation_matrix(const Quaternion& q);

// The Hermite spline at u = position / ticks; tangents are per second.
Exact hermite(double a, double out_tangent, double b, double in_tangent, long long position, long long ticks,
              long long ticks_per_second);

}  // namespace morphcl::reference
