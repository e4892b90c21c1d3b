// An edge cut by the near plane, from either end: both triangles that share it must get the same vertex.
#include <cmath>

#include "host/render/reference/clip_polygon.hpp"
#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

namespace {

constexpr float near_w = 0.125f;

using Cut = std::array<float, 3>;       // x, y, w where the edge meets w = near
using BothCuts = std::array<float, 6>;  // going from a to b, then from b to a

struct End {
  float x, y, w;
};

// Planes: x, y, w of an end in front of the plane, then of one behind it.
template <class CutEdge>
Variant<float> cutting(const char* name, const CutEdge& cut) {
  return elementwise32<6>(name, [cut](float ax, float ay, float aw, float bx, float by, float bw) {
    const Cut forth = cut(End{ax, ay, aw}, End{bx, by, bw}), back = cut(End{bx, by, bw}, End{ax, ay, aw});
    return BothCuts{forth[0], forth[1], forth[2], back[0], back[1], back[2]};
  });
}

Cut as_given(const End& a, const End& b) {
  const float t = (a.w - near_w) / (a.w - b.w);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}

Cut inside_to_outside(const End& first, const End& second) {
  const bool turn = first.w < second.w;
  const End a = turn ? second : first, b = turn ? first : second;
  const float t = (a.w - near_w) / (a.w - b.w);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), near_w};
}

Cut inside_to_outside_in_fp64(const End& first, const End& second) {
  const bool turn = first.w < second.w;
  const End a = turn ? second : first, b = turn ? first : second;
  const double t = (static_cast<double>(a.w) - near_w) / (static_cast<double>(a.w) - b.w);
  return {static_cast<float>(a.x + t * (static_cast<double>(b.x) - a.x)),
          static_cast<float>(a.y + t * (static_cast<double>(b.y) - a.y)), near_w};
}

// The product's clipper, on the segment; the guard band is too wide to matter.
Cut shipped_cut(const End& a, const End& b, const FramePlan& plan, const RasterGrid& grid) {
  const auto corner = [](const End& end) { return reference::Corner{{end.x, end.y, near_w, end.w}, {0, 0, 0}}; };
  const auto left = reference::clip_polygon({corner(a), corner(b)}, plan, grid);
  const reference::ClipPoint& p = left[a.w < b.w ? 0 : 1].clip;
  return {p.x, p.y, p.w};
}

Variant<float> shipped_clip() {
  FramePlan plan;
  plan.camera.near_plane[1] = 1;
  plan.camera.near_plane[2] = -near_w;
  plan.camera.near_w = near_w;
  plan.camera.near_depth = 1;
  return shipped(cutting("inside to outside, fma", [plan, grid = RasterGrid(2, 2)](const End& a, const End& b) {
    return shipped_cut(a, b, plan, grid);
  }));
}

InputFamily clip_family(const char* name, const char* text, int in_front, int behind, bool grazing, double pixels) {
  return {name, text,
          [=](Random& random, std::size_t count) {
            return drawn(random, 6, count, {}, [=](Random& r, double* in) {
              for (const int coordinate : {0, 1, 3, 4}) in[coordinate] = r.uniform(-1, 1);
              in[2] = near_w + r.binades(-6, in_front);
              in[5] = near_w - r.binades(-6, behind);
              if (grazing) in[5] = near_w - r.binades(-24, -20);
            });
          },
          pixels};
}

}  // namespace

Operation clip() {
  PlanarOperation<float> op;
  op.about = {.name = "clip",
              .title = "an edge cut by the near plane w = 1/8, from either end",
              .results = "clip space",
              .format = binary32,
              .plotted = Measure::wrong,
              .target = 0,
              .reason = "the same bits from both ends, on the plane itself: no crack between triangles"};
  op.results = 6;
  op.families = {
      clip_family("benign", "ends within 2 of the plane", 0, 0, false, 0),
      clip_family("wide", "ends up to 2^17 in front of the plane and behind it", 16, 16, false, 0),
      clip_family("adversarial", "one end 2^-24 to 2^-19 behind the plane", 0, 0, true, 0),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const Number t = (Number(in(2, i)) - near_w) / (Number(in(2, i)) - in(5, i));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Number a = in(axis, i), b = in(axis + 3, i);
      results[axis].value = a + t * (b - a);
      results[axis].magnitude = abs(a) + abs(b);
    }
    results[2].value = results[2].magnitude = near_w;
    for (std::size_t r = 0; r < 3; ++r) results[r + 3] = results[r];
  });
  op.events = {Measure::wrong};
  op.judge = [](const double* computed, const double*, EventCounts& events) {
    const bool same = computed[0] == computed[3] && computed[1] == computed[4] && computed[2] == computed[5];
    if (!same || computed[2] != near_w) events.count(Measure::wrong);
  };
  op.variants = {
      cutting("in the order given", as_given),
      cutting("inside to outside", inside_to_outside),
      shipped_clip(),
      cutting("inside to outside, t in fp64", inside_to_outside_in_fp64),
  };
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
