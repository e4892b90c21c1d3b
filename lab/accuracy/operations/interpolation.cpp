// Perspective-correct interpolation of an attribute along an edge of the screen.
#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

// The attribute at t of the way on the screen from corner 1 to corner 2.
float difference_form(float a1, float w1, float a2, float w2, float t) {
  const float p1 = a1 / w1, p2 = a2 / w2, q1 = 1 / w1, q2 = 1 / w2;
  return (p1 + t * (p2 - p1)) / (q1 + t * (q2 - q1));
}

// As the kernels shade: screen weights times 1 / w of the corners.
float weights_form(float a1, float w1, float a2, float w2, float t) {
  const float k1 = (1 - t) * (1 / w1), k2 = t * (1 / w2);
  return (k1 * a1 + k2 * a2) / (k1 + k2);
}

float products_form(float a1, float w1, float a2, float w2, float t) {
  const float k1 = w2 * (1 - t), k2 = w1 * t;
  return (a1 * k1 + a2 * k2) / (k1 + k2);
}

float fp64_form(float a1, float w1, float a2, float w2, float t) {
  const double k1 = w2 * (1.0 - t), k2 = static_cast<double>(w1) * t;
  return static_cast<float>((a1 * k1 + a2 * k2) / (k1 + k2));
}

// t = k / steps, exact, so that 1 - t is too; the ends are among them, and every second one is near an end.
InputFamily interpolation_family(const char* name, const char* text, int w_binades, int steps) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 5, count, {}, [=](Random& r, double* in) {
              in[0] = r.uniform(1, 2);
              in[2] = r.uniform(1, 2);
              in[1] = 1;
              in[3] = r.binades(0, w_binades - 1);
              if (r.integer(0, 1) == 1) std::swap(in[1], in[3]);
              int k = r.integer(0, steps);
              if (r.integer(0, 1) == 1) k = std::min(steps, r.integer(0, 16));
              if (r.integer(0, 1) == 1) k = steps - k;
              in[4] = k / static_cast<double>(steps);
            });
          }};
}

}  // namespace

Operation interpolation() {
  PlanarOperation<float> op;
  op.about = {.name = "interpolation",
              .title = "perspective-correct interpolation of an attribute between corners with w1 and w2",
              .results = "attribute",
              .format = binary32,
              .plotted = Measure::max_ulp,
              .target = 5,
              .reason = "5 ulp, which no colour of 16 bits shows"};
  op.families = {
      interpolation_family("benign", "w ratio up to 8, attributes in [1, 2), t = k / 1024", 3, 1024),
      interpolation_family("wide", "w ratio up to 2^10, t = k / 1024", 10, 1024),
      interpolation_family("adversarial", "w ratio up to 2^20, t = k / 2^22", 20, 1 << 22),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    const Number k1 = in(3, i) * (1 - Number(in(4, i))), k2 = in(1, i) * Number(in(4, i));
    result->value = (in(0, i) * k1 + in(2, i) * k2) / (k1 + k2);
    result->magnitude = result->value;
  });
  const char* program = "accuracy_interpolation_f32";
  op.variants = {
      with_kernel(elementwise32<5>("p + t (q - p)", inlined<difference_form>), program, "perspective_difference"),
      shipped(with_kernel(elementwise32<5>("weights / w", inlined<weights_form>), program, "perspective_weights")),
      with_kernel(elementwise32<5>("weights times other w", inlined<products_form>), program, "perspective_products"),
      elementwise32<5>("fp64", inlined<fp64_form>),
  };
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
