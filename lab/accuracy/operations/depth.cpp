// Depth buffers: whether two surfaces one behind the other are told apart, and what is left of a distance.
#include <cmath>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/depth_format.hpp"

namespace morphcl::accuracy {

namespace {

constexpr double near_plane = 0.1, far_plane = 1e5;  // metres, say

// Results: what is stored of the nearer and of the farther distance, and the distance that the first one stands for.
// Constants of a batch: nothing; its planes: the two distances.
Variant<double> stored(const std::string& name, DepthFormat format) {
  return elementwise64<2>(name, [format, range = DepthRange{near_plane, far_plane}](double nearer, double farther) {
    const double a = stored_depth(format, range, nearer), b = stored_depth(format, range, farther);
    // By distances, so that one order fits all formats; a tie stays a tie.
    const double order = is_nearer(format, a, b) ? 1 : is_nearer(format, b, a) ? -1 : 0;
    return std::array<double, 2>{distance_of_stored(format, range, a), order};
  });
}

// What a vertex stage in binary32 gives the buffer: depth = A + B / distance, then rounded to the format.
float forward_fp32(float distance) {
  constexpr float a = static_cast<float>(far_plane / (far_plane - near_plane)),
                  b = static_cast<float>(-far_plane * near_plane / (far_plane - near_plane));
  return (a * distance + b) / distance;
}

Variant<double> computed_in_fp32(const std::string& name, double steps) {
  return elementwise64<2>(name, [steps](double nearer, double farther) {
    const auto keep = [&](double distance) {
      const double depth = forward_fp32(static_cast<float>(distance));
      return steps > 0 ? std::nearbyint(std::min(std::max(depth, 0.0), 1.0) * steps) / steps : depth;
    };
    const double a = keep(nearer), b = keep(farther);
    const double distance = far_plane * near_plane / (far_plane - a * (far_plane - near_plane));
    return std::array<double, 2>{distance, a < b ? 1.0 : a > b ? -1.0 : 0.0};
  });
}

float reversed_fp32(float distance) { return static_cast<float>(near_plane) / distance; }

InputFamily depth_family(const char* name, const char* text, double gap) {
  return {name, text, [gap](Random& random, std::size_t count) {
            return drawn(random, 2, count, {}, [gap](Random& r, double* in) {
              // Each binade of distances is as likely: near 2^-3 to far 2^16.
              in[0] = static_cast<float>(r.binades(-3, 15));
              in[1] = static_cast<float>(in[0] * (1 + gap));
            });
          }};
}

}  // namespace

Operation depth() {
  PlanarOperation<double> op;
  op.about = {.name = "depth",
              .title = "two surfaces in a depth buffer, near 0.1 and far 100000; the distance that is left of one",
              .results = "distance",
              .format = binary32,
              .plotted = Measure::ties,
              .target = 0,
              .reason = "no pair that cannot be told apart"};
  op.results = 2;
  op.measured = 1;
  op.families = {
      depth_family("benign", "pairs 10^-3 apart, relative, from 0.125 to 65536", 1e-3),
      depth_family("wide", "pairs 10^-5 apart", 1e-5),
      depth_family("adversarial", "pairs 2^-21 apart", 0x1p-21),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    results[0].value = results[0].magnitude = in(0, i);
    results[1].value = 1;
  });
  op.events = {Measure::ties, Measure::inversions};
  op.judge = [](const double* computed, const double*, EventCounts& events) {
    if (computed[1] == 0) events.count(Measure::ties);
    if (computed[1] < 0) events.count(Measure::inversions);
  };
  op.variants = {
      stored("fixed 16", DepthFormat::fixed16),
      stored("fixed 24", DepthFormat::fixed24),
      stored("fixed 32", DepthFormat::fixed32),
      stored("float", DepthFormat::forward_float),
      shipped(stored("reversed float", DepthFormat::reversed_float)),
      computed_in_fp32("fp32 vertex stage, fixed 24", 0x1p24 - 1),
      computed_in_fp32("fp32 vertex stage, float", 0),
      elementwise64<2>("fp32 vertex stage, reversed",
                       [](double nearer, double farther) {
                         const float a = reversed_fp32(static_cast<float>(nearer)),
                                     b = reversed_fp32(static_cast<float>(farther));
                         return std::array<double, 2>{near_plane / a, a > b ? 1.0 : a < b ? -1.0 : 0.0};
                       }),
  };
  op.compared = 16384;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
