// Unit normals of a transformed surface.
#include <cmath>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/batch.hpp"

namespace morphcl::accuracy {

namespace {

using VertexNormal = std::array<float, 3>;

// Points are stretched by these factors, so normals are divided by them.
constexpr VertexNormal stretch = {1, 3, 0.5f};

template <class Real>
std::array<Real, 3> divided_by_length(Real x, Real y, Real z) {
  const Real length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

VertexNormal with_the_points_matrix(float x, float y, float z) {
  return divided_by_length(x * stretch[0], y * stretch[1], z * stretch[2]);
}

VertexNormal inverse_transpose(float x, float y, float z) {
  return divided_by_length(x / stretch[0], y / stretch[1], z / stretch[2]);
}

VertexNormal reciprocal_length(float x, float y, float z) {
  x /= stretch[0];
  y /= stretch[1];
  z /= stretch[2];
  const float r = 1 / std::sqrt(x * x + y * y + z * z);
  return {x * r, y * r, z * r};
}

VertexNormal normal_in_fp64(float x, float y, float z) {
  const auto unit = divided_by_length<double>(x / static_cast<double>(stretch[0]), y / static_cast<double>(stretch[1]),
                                              z / static_cast<double>(stretch[2]));
  return {static_cast<float>(unit[0]), static_cast<float>(unit[1]), static_cast<float>(unit[2])};
}

// The product's batch transform.
Variant<float> shipped_normals() {
  return {.name = "scaled by exponent",
          .prepare = [](const Batch& batch) -> Variant<float>::Run {
            AffineRows<float> rows;
            rows.x[0] = stretch[0];
            rows.y[1] = stretch[1];
            rows.z[2] = stretch[2];
            const auto plane = [&](std::size_t p) {
              return std::span<const float>(batch.stored.plane(p), batch.size());
            };
            const auto in = Vertices<const float>::separate(plane(0), plane(1), plane(2));
            return [in, transform = Transform<float>::normals(rows)](Planes<float>& results) {
              const auto out = [&](std::size_t p) { return std::span<float>(results.plane(p), results.size()); };
              transform_reference(transform, in, Vertices<float>::separate(out(0), out(1), out(2)));
            };
          },
          .ships = true};
}

InputFamily normal_family(const char* name, const char* text, int low, int high, int spread) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 3, count, {}, [=](Random& r, double* in) {
              const double size = r.binades(low, high);
              for (int axis = 0; axis < 3; ++axis) in[axis] = size * r.signed_binades(-spread, 0);
            });
          }};
}

}  // namespace

Operation normal() {
  PlanarOperation<float> op;
  op.about = {.name = "normal",
              .title = "unit normals of a surface that is stretched by (1, 3, 1/2)",
              .results = "of length 1",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 4,
              .reason = "4 u of the length 1"};
  op.results = 3;
  op.families = {
      normal_family("benign", "lengths about 1", -1, 0, 3),
      normal_family("wide", "lengths from 2^-50 to 2^50, components up to 2^20 apart", -50, 49, 20),
      normal_family("adversarial", "lengths from 2^-120 to 2^-80 and so squares below the smallest number", -120, -81,
                    3),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    std::array<Number, 3> v;
    for (std::size_t axis = 0; axis < 3; ++axis) v[axis] = Number(in(axis, i)) / stretch[axis];
    const Number length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      results[axis].value = v[axis] / length;
      results[axis].magnitude = 1;
    }
  });
  op.variants = {
      elementwise32<3>("the points' matrix", inlined<with_the_points_matrix>),
      elementwise32<3>("inverse transpose", inlined<inverse_transpose>),
      elementwise32<3>("times 1 / length", inlined<reciprocal_length>),
      shipped_normals(),
      elementwise32<3>("fp64", inlined<normal_in_fp64>),
  };
  op.streams = true;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
