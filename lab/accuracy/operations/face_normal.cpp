// The normal of a face: the cross product of two edges, which cancels where the face is thin.
#include <cmath>
#include <glm/glm.hpp>

#include "host/math/kahan.hpp"
#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

using FaceNormal = std::array<float, 3>;

FaceNormal naive_face_normal(float ax, float ay, float az, float bx, float by, float bz) {
  return {ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx};
}

FaceNormal one_fma(float ax, float ay, float az, float bx, float by, float bz) {
  return {std::fma(ay, bz, -(az * by)), std::fma(az, bx, -(ax * bz)), std::fma(ax, by, -(ay * bx))};
}

FaceNormal kahan(float ax, float ay, float az, float bx, float by, float bz) {
  return {difference_of_products(ay, bz, az, by), difference_of_products(az, bx, ax, bz),
          difference_of_products(ax, by, ay, bx)};
}

FaceNormal face_normal_in_fp64(float ax, float ay, float az, float bx, float by, float bz) {
  const auto difference = [](double a, double b, double c, double d) { return static_cast<float>(a * b - c * d); };
  return {difference(ay, bz, az, by), difference(az, bx, ax, bz), difference(ax, by, ay, bx)};
}

InputFamily face_normal_family(const char* name, const char* text, double angle, int low, int high) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 6, count, {}, [=](Random& r, double* in) {
              const double size = r.binades(low, high);
              for (int axis = 0; axis < 3; ++axis) {
                in[axis] = static_cast<float>(r.uniform(-1, 1) * size);
                in[axis + 3] = angle == 0 ? r.uniform(-1, 1) : in[axis] * (1 + angle * r.uniform(-1, 1));
              }
            });
          }};
}

}  // namespace

Operation face_normal() {
  PlanarOperation<float> op;
  op.about = {.name = "face-normal",
              .title = "the normal of a face, a x b",
              .results = "squared model units",
              .format = binary32,
              .plotted = Measure::max_ulp,
              .target = 1.5,
              .reason = "the bound of Kahan's difference of products"};
  op.results = 3;
  op.families = {
      face_normal_family("benign", "edges of any direction in the unit box", 0, 0, 0),
      face_normal_family("wide", "edges from 2^-20 to 2^20 long, within 10^-2 of parallel", 1e-2, -20, 19),
      face_normal_family("adversarial", "edges within 10^-5 of parallel: thin faces", 1e-5, 0, 0),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
      const Number first = Number(in(j, i)) * in(k + 3, i), second = Number(in(k, i)) * in(j + 3, i);
      results[axis].value = first - second;
      results[axis].magnitude = abs(first) + abs(second);
    }
  });
  op.variants = {
      elementwise32<6>("fp32 naive", inlined<naive_face_normal>),
      elementwise32<6>("fp32, one fma", inlined<one_fma>),
      shipped(elementwise32<6>("Kahan", inlined<kahan>)),
      elementwise32<6>("fp64", inlined<face_normal_in_fp64>),
  };
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
