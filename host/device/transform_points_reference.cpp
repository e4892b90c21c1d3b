#include "host/device/transform_points_reference.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/device/normal_rows.hpp"

static_assert(FLT_EVAL_METHOD == 0, "float expressions must be evaluated in float");

namespace morphcl {

namespace {

struct Point {
  float x, y, z;
};

float point_row(const MatrixRow& row, Point p) {
  return std::fma(p.x, row[0], std::fma(p.y, row[1], std::fma(p.z, row[2], row[3])));
}

float vector_row(const MatrixRow& row, Point v) { return std::fma(v.x, row[0], std::fma(v.y, row[1], v.z * row[2])); }

// By the power of two that brings the largest component to [1, 4), or a denormal one as near as one factor can.
Point scale_to_one(Point v) {
  const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const int exponent = std::bit_cast<std::int32_t>(largest) >> 23;
  const float factor = std::bit_cast<float>(std::max(254 - exponent, 1) << 23);
  return {v.x * factor, v.y * factor, v.z * factor};
}

Point normalize(Point v) {
  v = scale_to_one(v);
  const float length = std::sqrt(std::fma(v.x, v.x, std::fma(v.y, v.y, v.z * v.z)));
  const float divisor = length > 0 ? length : 1.0f;
  return {v.x / divisor, v.y / divisor, v.z / divisor};
}

template <class Operation>
void for_each_point(const ConstPointArrays& in, const PointArrays& out, Operation operation) {
  const std::size_t count = checked_size(in, out);
  for (std::size_t i = 0; i < count; ++i) {
    const Point result = operation(Point{in.x[i], in.y[i], in.z[i]});
    out.x[i] = result.x;
    out.y[i] = result.y;
    out.z[i] = result.z;
  }
}

}  // namespace

void transform_points_reference(const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  for_each_point(in, out, [&](Point p) {
    return Point{point_row(rows.x, p), point_row(rows.y, p), point_row(rows.z, p)};
  });
}

void project_points_reference(const ProjectiveRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  constexpr float none = std::numeric_limits<float>::infinity();
  for_each_point(in, out, [&](Point p) {
    const float w = point_row(rows.w, p);
    if (!(w > 0)) return Point{none, none, none};
    return Point{point_row(rows.x, p) / w, point_row(rows.y, p) / w, point_row(rows.z, p) / w};
  });
}

void transform_vectors_reference(const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  for_each_point(in, out, [&](Point v) {
    return Point{vector_row(rows.x, v), vector_row(rows.y, v), vector_row(rows.z, v)};
  });
}

void transform_normals_reference(const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  const AffineRows normals = normal_rows(rows);
  for_each_point(in, out, [&](Point n) {
    n = scale_to_one(n);
    return normalize({vector_row(normals.x, n), vector_row(normals.y, n), vector_row(normals.z, n)});
  });
}

}  // namespace morphcl
