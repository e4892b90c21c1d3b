// Eight transparent surfaces over each other and over what lies behind: one colour of one sample.
#include <array>
#include <cmath>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/half.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

constexpr std::size_t layers = 8;
constexpr std::size_t planes = 2 * layers + 1;  // from front to back: colour, alpha of each; then what lies behind

template <class... Values>
auto array_of(Values... values) {
  return std::array{values...};
}

// The kernels' way.
constexpr auto front_to_back = [](auto... values) {
  const auto in = array_of(values...);
  float color = 0, through = 1;
  for (std::size_t k = 0; k < layers; ++k) {
    color = std::fma(through * in[2 * k + 1], in[2 * k], color);
    through = std::fma(-through, in[2 * k + 1], through);
  }
  return in[2 * layers] * through + color;
};

constexpr auto front_to_back_unfused = [](auto... values) {
  const auto in = array_of(values...);
  float color = 0, through = 1;
  for (std::size_t k = 0; k < layers; ++k) {
    color = color + through * in[2 * k + 1] * in[2 * k];
    through = through * (1 - in[2 * k + 1]);
  }
  return in[2 * layers] * through + color;
};

// `store`: what becomes of a colour between two layers.
template <class Store>
constexpr auto back_to_front(Store store) {
  return [store](auto... values) {
    const auto in = array_of(values...);
    float color = store(in[2 * layers]);
    for (std::size_t k = layers; k-- > 0;) color = store(in[2 * k + 1] * in[2 * k] + (1 - in[2 * k + 1]) * color);
    return color;
  };
}
constexpr auto as_it_is = [](float color) { return color; };
constexpr auto in_half = [](float color) { return from_half(to_half(color)); };
constexpr auto in_8_bits = [](float color) { return std::floor(color * 255 + 0.5f) * (1.0f / 255); };

// Blending that needs no order: the mean of the surfaces by alpha, in front of what all of them let through.
constexpr auto average = [](auto... values) {
  const auto in = array_of(values...);
  float color = 0, alpha = 0, through = 1;
  for (std::size_t k = 0; k < layers; ++k) {
    color += in[2 * k + 1] * in[2 * k];
    alpha += in[2 * k + 1];
    through *= 1 - in[2 * k + 1];
  }
  return (alpha > 0 ? color / alpha : 0) * (1 - through) + in[2 * layers] * through;
};

constexpr auto fp64 = [](auto... values) {
  const auto in = array_of(values...);
  double color = 0, through = 1;
  for (std::size_t k = 0; k < layers; ++k) {
    color += through * in[2 * k + 1] * in[2 * k];
    through *= 1.0 - in[2 * k + 1];
  }
  return static_cast<float>(in[2 * layers] * through + color);
};

// `alpha` draws the alpha of a layer.
template <class Alpha>
InputFamily blending_family(const char* name, const char* text, Alpha alpha) {
  return {name, text, [alpha](Random& random, std::size_t count) {
            return drawn(random, planes, count, {}, [alpha](Random& r, double* in) {
              for (std::size_t k = 0; k < layers; ++k) {
                in[2 * k] = r.uniform(0, 1);
                in[2 * k + 1] = alpha(r);
              }
              in[2 * layers] = r.uniform(0, 1);
            });
          }};
}

}  // namespace

Operation blending() {
  PlanarOperation<float> op;
  op.about = {.name = "blending",
              .title = "eight transparent surfaces over each other: a colour of a sample",
              .results = "colour",
              .format = binary32,
              .plotted = Measure::max_ulp,
              .target = 10,
              .reason = "two roundings a layer, four at the end; a half has 8192 of these ulps",
              .element = "a colour"};
  op.families = {
      blending_family("benign", "colours and alphas in [0, 1)", [](Random& r) { return r.uniform(0, 1); }),
      blending_family("wide", "alphas from 2^-20 to 1", [](Random& r) { return r.binades(-20, -1); }),
      blending_family("adversarial", "alphas within 2^-20 of 1, or 0 or 1, in turn",
                      [](Random& r) { return r.integer(0, 7) == 0 ? r.integer(0, 1) : 1 - r.binades(-20, -12); }),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    Number color = in(2 * layers, i);
    for (std::size_t k = layers; k-- > 0;) {
      const Number alpha = in(2 * k + 1, i);
      color = alpha * in(2 * k, i) + (1 - alpha) * color;
    }
    result->value = color;
    result->magnitude = color;
  });
  op.variants = {
      shipped(elementwise32<planes>("front to back, fused", front_to_back)),
      elementwise32<planes>("front to back", front_to_back_unfused),
      elementwise32<planes>("back to front", back_to_front(as_it_is)),
      elementwise32<planes>("back to front in a half", back_to_front(in_half)),
      elementwise32<planes>("back to front in 8 bits", back_to_front(in_8_bits)),
      elementwise32<planes>("weighted average", average),
      elementwise32<planes>("fp64", fp64),
  };
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
