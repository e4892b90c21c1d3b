// Linear interpolation of morphed coordinates: (1 - t) a + t b.
#include "morphcl/numerics.hpp"

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

std::vector<Variant<float>> lerp_variants() {
  const char* program = "accuracy_interpolation_f32";
  return {
      with_kernel(elementwise32<3>("a + t (b - a)", [](float a, float b, float t) { return a + t * (b - a); }), program,
                  "lerp_difference"),
      with_kernel(elementwise32<3>("(1 - t) a + t b", [](float a, float b, float t) { return (1 - t) * a + t * b; }),
                  program, "lerp_weights"),
      shipped(with_kernel(
          elementwise32<3>("fma(t, b, fma(-t, a, a))", [](float a, float b, float t) { return lerp(a, b, t); }),
          program, "lerp_fused")),
      elementwise32<3>("fp64",
                       [](float a, float b, float t) {
                         return static_cast<float>((1.0 - t) * static_cast<double>(a) + static_cast<double>(t) * b);
                       }),
  };
}

}  // namespace

Operation lerp_morph() {
  PlanarOperation<float> op;
  op.about = {.name = "lerp",
              .title = "morphing a coordinate: (1 - t) a + t b",
              .results = "model units",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 2,
              .reason = "two roundings of the larger value"};
  op.families = {
      {"benign", "a and b in [0, 1), t in [0, 1]",
       [](Random& random, std::size_t count) {
         return drawn(random, 3, count, {}, [](Random& r, double* in) {
           in[0] = r.uniform(0, 1);
           in[1] = r.uniform(0, 1);
           in[2] = r.integer(0, 100) / 100.0;
         });
       },
       1080},
      {"wide", "a and b of either sign from 2^-20 to 2^20",
       [](Random& random, std::size_t count) {
         return drawn(random, 3, count, {}, [](Random& r, double* in) {
           in[0] = r.signed_binades(-20, 19);
           in[1] = r.signed_binades(-20, 19);
           in[2] = r.uniform(0, 1);
         });
       },
       1080 / 0x1p21},
      {"adversarial", "t = 0 or 1, equal ends, or ends at +-3e38, in turn",
       [](Random& random, std::size_t count) {
         return drawn(random, 3, count, {}, [kind = 0](Random& r, double* in) mutable {
           in[0] = r.signed_binades(-20, 19);
           in[1] = r.signed_binades(-20, 19);
           in[2] = r.integer(0, 1);
           if (kind % 3 == 1) {
             in[1] = in[0];
             in[2] = r.uniform(0, 1);
           }
           if (kind % 3 == 2) {
             in[0] = 3e38;
             in[1] = -3e38;
             in[2] = r.uniform(0, 1);
           }
           ++kind;
         });
       }},
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    const Number a = in(0, i), b = in(1, i), t = in(2, i);
    result->value = (1 - t) * a + t * b;
    result->magnitude = abs(a) > abs(b) ? abs(a) : abs(b);
  });
  op.variants = lerp_variants();
  op.streams = true;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
