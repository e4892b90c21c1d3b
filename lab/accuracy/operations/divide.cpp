// The perspective divide: (X, Y, Z) / w.
#include <cmath>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

using Quotients = std::array<float, 3>;

Quotients by_reciprocal(float x, float y, float z, float w) {
  const float r = 1 / w;
  return {x * r, y * r, z * r};
}

// One step of Newton's method on the quotient: correctly rounded but for a few in a million.
float corrected(float v, float w, float r) {
  const float q = v * r;
  return std::fma(std::fma(-q, w, v), r, q);
}

Quotients by_corrected_reciprocal(float x, float y, float z, float w) {
  const float r = 1 / w;
  return {corrected(x, w, r), corrected(y, w, r), corrected(z, w, r)};
}

Quotients by_division(float x, float y, float z, float w) { return {x / w, y / w, z / w}; }

Quotients quotients_in_fp64(float x, float y, float z, float w) {
  const double r = 1.0 / w;
  return {static_cast<float>(x * r), static_cast<float>(y * r), static_cast<float>(z * r)};
}

InputFamily divide_family(const char* name, const char* text, int low, int high, double w_low, double w_high,
                          double pixels) {
  return {name, text,
          [=](Random& random, std::size_t count) {
            return drawn(random, 4, count, {}, [=](Random& r, double* in) {
              for (int axis = 0; axis < 3; ++axis) in[axis] = r.signed_binades(low, high);
              const auto w_exponent = static_cast<int>(std::floor(r.uniform(w_low, w_high)));
              in[3] = std::ldexp(r.uniform(1, 2), w_exponent);
            });
          },
          pixels};
}

}  // namespace

Operation divide() {
  PlanarOperation<float> op;
  op.about = {.name = "divide",
              .title = "the perspective divide (x, y, z) / w",
              .results = "NDC",
              .format = binary32,
              .plotted = Measure::max_ulp,
              .target = 0.501,
              .reason = "the correctly rounded quotient, the same on every device"};
  op.results = 3;
  op.families = {
      divide_family("benign", "coordinates of either sign from 1/8 to 1, w from 1 to 16; 960 pixels a unit", -3, -1, 0,
                    4, 960),
      divide_family("wide", "coordinates from 2^-20 to 2^20, w from 2^-20 to 2^20", -20, 19, -20, 20, 0),
      divide_family("adversarial",
                    "w from 2^-149 to 2^-120, coordinates as small: 1 / w overflows, the quotient does not", -126, -118,
                    -149, -120, 0),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      results[axis].value = Number(in(axis, i)) / in(3, i);
      results[axis].magnitude = abs(results[axis].value);
    }
  });
  op.variants = {
      elementwise32<4>("times 1 / w", inlined<by_reciprocal>),
      elementwise32<4>("times 1 / w, corrected", inlined<by_corrected_reciprocal>),
      shipped(elementwise32<4>("three divisions", inlined<by_division>)),
      elementwise32<4>("fp64 times 1 / w", inlined<quotients_in_fp64>),
  };
  op.streams = true;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
