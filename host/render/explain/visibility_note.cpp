#include "host/render/explain/visibility_note.hpp"

#include <fmt/core.h>

namespace morphcl {

namespace {

// Measured with closed meshes of 500 to 800,000 triangles, of which half face the eye, at 1920 x 1080
// (docs/visibility.md). What splits much takes longer.
struct MethodCost {
  double triangle, pixel;  // nanoseconds
  const char* does;
};

MethodCost cost_of(VisibilityMethod method) {
  switch (method) {
    case VisibilityMethod::painter:
      return {600, 4, "sorts all triangles by depth, splits what has no order, and paints from back to front"};
    case VisibilityMethod::bsp:
      return {1100, 4, "parts space by planes of the triangles, and paints the tree from back to front"};
    case VisibilityMethod::warnock:
      return {400, 5, "divides windows in four until each is simple"};
    case VisibilityMethod::watkins:
      return {150, 1, "compares spans on every scan line"};
    case VisibilityMethod::z_buffer:
      break;
  }
  return {0, 0, ""};
}

}  // namespace

std::optional<PlanNote> visibility_note(const FramePlan& plan, const Workload& work) {
  if (plan.visibility == VisibilityMethod::z_buffer) return std::nullopt;
  const MethodCost cost = cost_of(plan.visibility);
  return PlanNote{"hidden surfaces", true,
                  fmt::format("{} is asked for: it {}; the reference renderer draws, the pixels are those of the "
                              "z-buffer",
                              name_of(plan.visibility), cost.does),
                  1e-6 * (cost.triangle * work.triangles + cost.pixel * work.pixels)};
}

}  // namespace morphcl
