// From clip space to the sub-pixel grid: x / w, times half the width, rounded to 1/256 pixel.
#include <cmath>

#include "host/render/frame/scene_vertices.hpp"
#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

// A batch's constant is the width of a square image in pixels; results are sub-pixels along x.

template <class Snap>
Variant<float> snapping(const char* name, Snap snap) {
  return {.name = name, .prepare = [snap](const Batch& batch) -> Variant<float>::Run {
            const float scale = static_cast<float>(batch.constants[0]) * 128;
            const float *x = batch.stored.plane(0), *w = batch.stored.plane(1);
            return [=, count = batch.size()](Planes<float>& results) {
              float* out = results.plane(0);
              for_each_element(count, [=](std::size_t i) { out[i] = snap(x[i], w[i], scale); });
            };
          }};
}

Variant<float> shipped_snap() {
  return {.name = "fp32 compensated",
          .prepare = [](const Batch& batch) -> Variant<float>::Run {
            const int width = static_cast<int>(batch.constants[0]);
            const float *x = batch.stored.plane(0), *w = batch.stored.plane(1);
            return [=, grid = RasterGrid(width, width), count = batch.size()](Planes<float>& results) {
              float* out = results.plane(0);
              for (std::size_t i = 0; i < count; ++i)
                out[i] = static_cast<float>(reference::to_screen({x[i], 0, 0, w[i]}, grid).x);
            };
          },
          .ships = true};
}

// Far from a tie or next to one: within a few units in the last place of the quotient.
InputFamily snap_family(const char* name, const char* text, int width, bool near_ties) {
  return {name, text,
          [=](Random& random, std::size_t count) {
            return drawn(random, 2, count, {static_cast<double>(width)}, [=](Random& r, double* in) {
              in[1] = static_cast<float>(r.uniform(1, 16));
              in[0] = r.uniform(-1, 1) * in[1];
              if (!near_ties) return;
              const double subpixel = r.integer(0, width * 256 - 1) + 0.5;
              const double x = (subpixel / (width * 128.0) - 1) * in[1];
              in[0] = static_cast<float>(x * (1 + r.integer(-3, 3) * 0x1p-24));
            });
          },
          1.0 / 256};
}

}  // namespace

Operation viewport_snap() {
  PlanarOperation<float> op;
  op.about = {.name = "viewport-snap",
              .title = "clip space to the viewport, snapped to 1/256 pixel",
              .results = "sub-pixels",
              .format = binary32,
              .plotted = Measure::wrong,
              .target = 0,
              .reason = "no vertex on another sub-pixel than the exact one"};
  op.families = {
      snap_family("benign", "1920 pixels wide, w from 1 to 16", 1920, false),
      snap_family("wide", "16384 pixels wide", 16384, false),
      snap_family("adversarial", "16384 pixels wide, within three ulp of a tie", 16384, true),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    const Number scale = in.constant(0) * 128;
    result->value = in(0, i) / Number(in(1, i)) * scale + scale;
    result->magnitude = abs(result->value) + scale;
  });
  op.relative = false;
  op.events = {Measure::wrong};
  op.judge = [](const double* computed, const double* exact, EventCounts& events) {
    if (computed[0] != std::nearbyint(exact[0])) events.count(Measure::wrong);
  };
  op.variants = {
      snapping("fp32 naive", [](float x, float w, float scale) { return std::nearbyint(x / w * scale + scale); }),
      snapping("fp32 fma", [](float x, float w, float scale) { return std::nearbyint(std::fma(x / w, scale, scale)); }),
      shipped_snap(),
      snapping("fp64 fma",
               [](float x, float w, float scale) {
                 return static_cast<float>(std::nearbyint(std::fma(static_cast<double>(x) / w, scale, scale)));
               }),
  };
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
