// Cubic keys: the Hermite spline between two values with their tangents.
#include <cmath>
#include <memory>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/track.hpp"

namespace morphcl::accuracy {

namespace {

// Planes: a, its tangent, b, its tangent (per second), ticks from a, ticks between the keys; a second has 25e6 ticks.
constexpr std::int64_t ticks_per_second = 25'000'000;

// (2u^3 - 3u^2 + 1) a + (u^3 - 2u^2 + u) h m + (3u^2 - 2u^3) b + (u^3 - u^2) h n
template <class Real>
double by_powers(double a, double m, double b, double n, double ticks, double all_ticks) {
  const Real u = static_cast<Real>(ticks / all_ticks), u2 = u * u, u3 = u2 * u;
  const Real seconds = static_cast<Real>(all_ticks / ticks_per_second);
  const Real value = (2 * u3 - 3 * u2 + 1) * Real(a) + (u3 - 2 * u2 + u) * seconds * Real(m) +
                     (3 * u2 - 2 * u3) * Real(b) + (u3 - u2) * seconds * Real(n);
  return static_cast<double>(value);
}

// c0 + u (c1 + u (c2 + u c3))
template <class Real>
double by_coefficients(double a, double m, double b, double n, double ticks, double all_ticks) {
  const Real u = static_cast<Real>(ticks / all_ticks), seconds = static_cast<Real>(all_ticks / ticks_per_second);
  const Real c0 = Real(a), c1 = seconds * Real(m), rise = Real(b) - c0, end = seconds * Real(n);
  const Real c2 = 3 * rise - 2 * c1 - end, c3 = c1 + end - 2 * rise;
  return static_cast<double>(c0 + u * (c1 + u * (c2 + u * c3)));
}

Variant<double> shipped_track() {
  return {.name = "Track",
          .prepare = [](const Batch& batch) -> Variant<double>::Run {
            auto tracks = std::make_shared<std::vector<Track>>();
            const auto in = [&](std::size_t p, std::size_t i) { return batch.truth.plane(p)[i]; };
            for (std::size_t i = 0; i < batch.size(); ++i)
              tracks->emplace_back(TickKeys{.interpolation = Interpolation::cubic,
                                            .ticks_per_second = ticks_per_second,
                                            .ticks = {0, static_cast<std::int64_t>(in(5, i))},
                                            .values = {0, in(0, i), in(1, i), in(3, i), in(2, i), 0}});
            return [tracks, ticks = batch.truth.plane(4)](Planes<double>& results) {
              for (std::size_t i = 0; i < tracks->size(); ++i)
                (*tracks)[i].evaluate(static_cast<std::int64_t>(ticks[i]), &results.plane(0)[i]);
            };
          },
          .ships = true};
}

InputFamily hermite_family(const char* name, const char* text, auto fill) {
  return {name, text, [fill](Random& random, std::size_t count) { return drawn(random, 6, count, {}, fill); }};
}

}  // namespace

Operation hermite() {
  PlanarOperation<double> op;
  op.about = {.name = "hermite",
              .title = "a cubic track between two keys",
              .results = "the track's unit",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 0.5,
              .reason = "below the one rounding to binary32 that follows"};
  op.families = {
      hermite_family("benign", "values and tangents within 1, keys 1 to 4 seconds apart",
                     [](Random& r, double* in) {
                       for (int k = 0; k < 4; ++k) in[k] = r.uniform(-1, 1);
                       in[5] = r.integer(25'000'000, 100'000'000);
                       in[4] = std::floor(in[5] * r.uniform(0, 1));
                     }),
      hermite_family("wide", "values and tangents of either sign from 2^-20 to 2^20",
                     [](Random& r, double* in) {
                       for (int k = 0; k < 4; ++k) in[k] = r.signed_binades(-20, 19);
                       in[5] = r.integer(250'000, 1'000'000'000);
                       in[4] = std::floor(in[5] * r.uniform(0, 1));
                     }),
      hermite_family("adversarial", "values about 10^6 with 1 between the keys, just before the second key",
                     [](Random& r, double* in) {
                       in[0] = 1e6 + r.uniform(-1, 1);
                       in[2] = 1e6 + r.uniform(-1, 1);
                       in[1] = r.uniform(-1, 1);
                       in[3] = r.uniform(-1, 1);
                       in[5] = r.integer(25'000'000, 100'000'000);
                       in[4] = in[5] - r.integer(1, 1000);
                     }),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    const Number u = Number(in(4, i)) / in(5, i), v = 1 - u,
                 seconds = Number(in(5, i)) / static_cast<double>(ticks_per_second);
    const Number terms[4] = {v * v * (1 + 2 * u) * in(0, i), u * v * v * seconds * in(1, i),
                             u * u * (1 + 2 * v) * in(2, i), -u * u * v * seconds * in(3, i)};
    for (const Number& term : terms) {
      result->value += term;
      result->magnitude += abs(term);
    }
  });
  op.variants = {
      elementwise64<6>("powers in fp32", inlined<by_powers<float>>),
      elementwise64<6>("coefficients in fp32", inlined<by_coefficients<float>>),
      elementwise64<6>("powers in fp64", inlined<by_powers<double>>),
      elementwise64<6>("coefficients in fp64", inlined<by_coefficients<double>>),
      shipped_track(),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
