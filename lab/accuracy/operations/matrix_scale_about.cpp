// Scaling about a point: X + S (x - X), as a matrix S x + (1 - S) X or as it is written.
#include <cmath>
#include <glm/glm.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::accuracy {

namespace {

// Planes: x. Constants: the point X and the factor S, both binary32.

struct Scaling {
  float point, factor;
};

// prepare(scaling) makes the function that is applied to each x.
template <class Prepare>
Variant<float> applied(const char* name, Prepare prepare) {
  return {.name = name, .prepare = [prepare](const Batch& batch) -> Variant<float>::Run {
            const auto apply =
                prepare(Scaling{static_cast<float>(batch.constants[0]), static_cast<float>(batch.constants[1])});
            return [apply, x = batch.stored.plane(0), count = batch.size()](Planes<float>& results) {
              float* out = results.plane(0);
              for_each_element(count, [=](std::size_t i) { out[i] = apply(x[i]); });
            };
          }};
}

auto matrix_in_fp32(Scaling s) {
  return [factor = s.factor, shift = (1 - s.factor) * s.point](float x) { return factor * x + shift; };
}

auto about_in_fp32(Scaling s) {
  return [s](float x) { return s.point + s.factor * (x - s.point); };
}

auto about_by_fma(Scaling s) {
  return [s](float x) { return std::fma(s.factor, x - s.point, s.point); };
}

auto matrix_in_fp64(Scaling s) {
  const double factor = s.factor;
  return [factor, shift = (1 - factor) * s.point](float x) {
    return static_cast<float>(std::fma(factor, static_cast<double>(x), shift));
  };
}

// The product's step, composed in fp64 and rounded to fp32 once.
auto shipped_step(Scaling s) {
  const glm::dmat4 m = CompositeTransform().scale_about(glm::dvec3(s.point), glm::dvec3(s.factor)).matrix();
  return [factor = static_cast<float>(m[0][0]), shift = static_cast<float>(m[3][0])](float x) {
    return std::fma(x, factor, shift);
  };
}

InputFamily scale_about_family(const char* name, const char* text, double point, double factor, double spread,
                               double pixels) {
  return {name, text,
          [=](Random& random, std::size_t count) {
            const double at = static_cast<float>(point), by = static_cast<float>(factor);
            return drawn(random, 1, count, {at, by},
                         [=](Random& r, double* in) { in[0] = at + spread * r.uniform(-1, 1); });
          },
          pixels};
}

}  // namespace

Operation matrix_scale_about() {
  PlanarOperation<float> op;
  op.about = {.name = "matrix-scale-about",
              .title = "scaling about a point, applied to a coordinate",
              .results = "model units",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 2,
              .reason = "two roundings of the larger term"};
  op.families = {
      scale_about_family("benign", "by 1.7 about 0.3, coordinates within 1 of it", 0.3, 1.7, 1, 540),
      scale_about_family("wide", "by 0.37 about 1234.5, coordinates within 100 of it", 1234.5, 0.37, 100, 5.4),
      scale_about_family("adversarial", "by 2.9 about 10^8, coordinates within 1000 of it", 1e8, 2.9, 1000, 0.54),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    const Number x = in(0, i), point = in.constant(0), factor = in.constant(1);
    result->value = point + factor * (x - point);
    result->magnitude = abs(point) + abs(factor * (x - point));
  });
  op.variants = {
      applied("S x + (1 - S) X in fp32", matrix_in_fp32), applied("X + S (x - X) in fp32", about_in_fp32),
      applied("X + S (x - X) by fma", about_by_fma),      shipped(applied("composed in fp64, fma", shipped_step)),
      applied("S x + (1 - S) X in fp64", matrix_in_fp64),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
