#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "host/batch/transform.hpp"
#include "host/batch/vertices.hpp"
#include "host/math/hardware_fma.hpp"
#include "morphcl/batch.hpp"

static_assert(FLT_EVAL_METHOD == 0, "float expressions must be evaluated in float");

namespace morphcl {

namespace {

template <class Real>
struct Vector {
  Real x, y, z;
};

template <class Real>
struct Product {
  Real x, y, z, w;
};

template <class Real>
struct Exponent;
template <>
struct Exponent<float> {
  using Bits = std::int32_t;
  static constexpr int fraction_bits = 23, max_finite = 254;
};
template <>
struct Exponent<double> {
  using Bits = std::int64_t;
  static constexpr int fraction_bits = 52, max_finite = 2046;
};

template <class Real>
MORPHCL_INLINED Real times(const MatrixRow<Real>& row, Vector<Real> p) {
  return std::fma(p.x, row[0], std::fma(p.y, row[1], std::fma(p.z, row[2], row[3])));
}

template <class Real>
MORPHCL_INLINED Real larger(Real a, Real b) {
  return a > b ? a : b;
}

// By the power of two that brings the largest component to [1, 4), or a denormal one as near as one factor can.
template <class Real>
MORPHCL_INLINED Vector<Real> scale_to_one(Vector<Real> v) {
  using Bits = typename Exponent<Real>::Bits;
  const Real largest = larger(std::abs(v.x), larger(std::abs(v.y), std::abs(v.z)));
  const Bits exponent = std::bit_cast<Bits>(largest) >> Exponent<Real>::fraction_bits;
  const Bits inverse = std::max<Bits>(Exponent<Real>::max_finite - exponent, 1);
  const Real factor = std::bit_cast<Real>(inverse << Exponent<Real>::fraction_bits);
  return {v.x * factor, v.y * factor, v.z * factor};
}

template <class Real>
MORPHCL_INLINED Vector<Real> normalize(Vector<Real> v) {
  v = scale_to_one(v);
  const Real length = std::sqrt(std::fma(v.x, v.x, std::fma(v.y, v.y, v.z * v.z)));
  const Real divisor = length > 0 ? length : Real{1};
  return {v.x / divisor, v.y / divisor, v.z / divisor};
}

template <class Real>
MORPHCL_INLINED Product<Real> multiply(const MatrixRow<Real>* rows, Vector<Real> p, bool projective) {
  return {times(rows[0], p), times(rows[1], p), times(rows[2], p), projective ? times(rows[3], p) : Real{0}};
}

template <class Real>
MORPHCL_INLINED Vector<Real> finish(Product<Real> q, TransformKind kind) {
  if (kind == TransformKind::normals) return normalize<Real>({q.x, q.y, q.z});
  if (kind == TransformKind::affine) return {q.x, q.y, q.z};
  constexpr Real none = std::numeric_limits<Real>::infinity();
  if (!(q.w > 0)) return {none, none, none};
  return {q.x / q.w, q.y / q.w, q.z / q.w};
}

// The matrix, or the sum of matrices, that vertex i goes through, applied to p; false if it asks for one that is not
// there.
template <class Real>
MORPHCL_INLINED bool multiply_chosen(std::span<const MatrixRow<Real>> matrices, bool projective,
                                     const MatrixChoice<Real>& choice, std::size_t i, Vector<Real> p,
                                     Product<Real>& q) {
  const std::size_t per_matrix = projective ? 4 : 3;
  const MatrixRow<Real>* rows = matrices.data();
  const std::size_t end = matrices.size();
  if (const auto* index = std::get_if<MatrixIndices>(&choice)) {
    const std::size_t first = (*index)[i] * per_matrix;
    if (first >= end) return false;
    q = multiply(rows + first, p, projective);
  } else if (const auto* blend = std::get_if<MatrixBlend<Real>>(&choice)) {
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t first = blend->matrices[i][k] * per_matrix;
      if (first >= end) return false;
      const Product<Real> r = multiply(rows + first, p, projective);
      const Real weight = blend->weights[i][k];
      if (k == 0)
        q = {weight * r.x, weight * r.y, weight * r.z, weight * r.w};
      else
        q = {std::fma(weight, r.x, q.x), std::fma(weight, r.y, q.y), std::fma(weight, r.z, q.z),
             std::fma(weight, r.w, q.w)};
    }
  } else {
    q = multiply(rows, p, projective);
  }
  return true;
}

template <class Real>
MORPHCL_INLINED void transform_each(TransformKind kind, std::span<const MatrixRow<Real>> matrices,
                                    const Vertices<const Real>& in, const Vertices<Real>& out,
                                    const MatrixChoice<Real>& choice) {
  const Real *x = in.coordinates(0), *y = in.coordinates(1), *z = in.coordinates(2);
  Real *out_x = out.coordinates(0), *out_y = out.coordinates(1), *out_z = out.coordinates(2);
  const std::size_t stride = in.stride(), count = in.size();
  const bool projective = kind == TransformKind::projective;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * stride;
    Vector<Real> p{x[at], y[at], z[at]};
    if (kind == TransformKind::normals) p = scale_to_one(p);
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    Product<Real> q{};
    const bool found = multiply_chosen(matrices, projective, choice, i, p, q);
    const Vector<Real> result = found ? finish(q, kind) : Vector<Real>{nan, nan, nan};
    if (in.layout() == VertexLayout::xyzw) out.carried()[at] = in.carried()[at];
    out_x[at] = result.x;
    out_y[at] = result.y;
    out_z[at] = result.z;
  }
}

// The span of the matrices comes from outside: Clang 19 does not emit an inline function that nothing but such a
// function calls, as Transform::rows() calls the span's constructor.
MORPHCL_WITH_HARDWARE_FMA void transform_floats(TransformKind kind, std::span<const MatrixRow<float>> matrices,
                                                const Vertices<const float>& in, const Vertices<float>& out,
                                                const MatrixChoice<float>& choice) {
  transform_each(kind, matrices, in, out, choice);
}

MORPHCL_WITH_HARDWARE_FMA void transform_doubles(TransformKind kind, std::span<const MatrixRow<double>> matrices,
                                                 const Vertices<const double>& in, const Vertices<double>& out,
                                                 const MatrixChoice<double>& choice) {
  transform_each(kind, matrices, in, out, choice);
}

}  // namespace

template <>
void transform_reference(const Transform<float>& transform, const Vertices<const float>& in, const Vertices<float>& out,
                         const MatrixChoice<float>& choice) {
  check_in_and_out(in, out);
  check_choice(transform, choice, in.size());
  transform_floats(transform.kind(), transform.rows(), in, out, choice);
}

template <>
void transform_reference(const Transform<double>& transform, const Vertices<const double>& in,
                         const Vertices<double>& out, const MatrixChoice<double>& choice) {
  check_in_and_out(in, out);
  check_choice(transform, choice, in.size());
  transform_doubles(transform.kind(), transform.rows(), in, out, choice);
}

}  // namespace morphcl
