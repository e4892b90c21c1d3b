#include "host/render/plan/vertex_bounds.hpp"
#include "host/math/unit_roundoff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphcl {

namespace {

constexpr double u32 = unit_roundoff<float>, u64 = unit_roundoff<double>;
constexpr double half_grid_step = (1 + 0x1p-20) / 512;  // pixels; a vertex next to a tie may take the other side
constexpr double tiny = 0x1p-120;                       // underflow
constexpr double second_order = 1 + 1e-5;               // products of errors, for up to 10^5 roundings
constexpr double infinity = std::numeric_limits<double>::infinity();

glm::dvec4 row_of(const glm::dmat4& m, int row) { return {m[0][row], m[1][row], m[2][row], m[3][row]}; }

// |m| |p| + |constant|.
double terms_of(const glm::dvec4& row, const glm::dvec3& p, double constant) {
  return glm::dot(glm::abs(glm::dvec3(row)), p) + std::abs(constant);
}

// How far a clip coordinate may be off, beside the final rounding of two_float.
double row_error(const VertexTerms& t, VertexForm form, int r) {
  const glm::dvec4 row = row_of(t.object_to_clip, r), linear(glm::dvec3(row), 0);
  const glm::dvec3 farthest = glm::max(glm::abs(t.box.lower), glm::abs(t.box.upper));
  const double composed = 8 * u64 * terms_of(row_of(t.magnitudes, r), farthest, t.magnitudes[3][r]);
  const double terms = terms_of(row, farthest, row.w);
  const double steps = 2.0 * t.targets;  // roundings of a morphed position, weights apart
  double error = 0;
  switch (form) {
    case VertexForm::plain:
      error = 4 * u32 * terms + (t.targets ? (steps + 1) * u32 * terms_of(linear, t.plain_terms, 0) : 0);
      break;
    case VertexForm::pivot: {
      const glm::dvec3 reach = glm::max(t.box.upper - t.pivot, t.pivot - t.box.lower);
      const double constant = glm::dot(glm::dvec3(row), t.pivot) + row.w;
      const double recentred = 4 * u64 * terms_of(row, glm::abs(t.pivot), row.w);
      error =
          4 * u32 * terms_of(row, reach, constant) + (steps + 2) * u32 * terms_of(linear, t.pivot_terms, 0) + recentred;
      break;
    }
    case VertexForm::two_float:
      error = 16 * u32 * u32 * terms + 8 * (steps + 1) * u32 * u32 * terms_of(linear, t.plain_terms, 0);
      break;
  }
  return (error + composed) * second_order + tiny;
}

// w of the box's corners, and the largest |coordinate / w| there; of a box that is entirely in front of the eye, the
// corners have the extremes.
struct Corners {
  double min_w = infinity;
  double largest_ratio[2] = {0, 0};
};
Corners corners_of(const VertexTerms& t) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 p = t.object_to_clip * glm::dvec4(t.box.corner(i), 1.0);
    corners.min_w = std::min(corners.min_w, p.w);
    for (int axis = 0; axis < 2; ++axis)
      corners.largest_ratio[axis] = std::max(corners.largest_ratio[axis], std::abs(p[axis] / p.w));
  }
  return corners;
}

}  // namespace

std::array<double, 3> vertex_error_bounds(const VertexTerms& terms, const ScreenOfVertices& screen) {
  const Corners corners = corners_of(terms);
  std::array<double, 3> bounds{};
  for (const VertexForm form : vertex_forms) {
    double& bound = bounds[static_cast<std::size_t>(form)];
    // Parallel projections: w is 1 and has no error.
    const bool divides = row_of(terms.object_to_clip, 3) != glm::dvec4(0, 0, 0, 1);
    const double error_w = divides ? row_error(terms, form, 3) : 0;
    const double rounded = form == VertexForm::two_float ? (divides ? 2 : 1) * u32 * second_order : 0;
    for (const int axis : {0, 1}) {
      const double error = row_error(terms, form, axis), guard = axis == 0 ? screen.guard_x : screen.guard_y;
      const auto moved = [&](double ratio, double w) {
        return w > 0 ? (error + ratio * error_w) / w + rounded * ratio : infinity;
      };
      // Either the exact quotient is bounded and the computed w, or the other way round.
      double relative = moved(guard * (1 + 0x1p-20), std::max(corners.min_w, screen.near_w - error_w));
      if (corners.min_w > 0)
        relative = std::min(relative, moved(corners.largest_ratio[axis] * (1 + 1e-9),
                                            std::max(double{screen.near_w}, corners.min_w - error_w)));
      const double pixels = 0.5 * (axis == 0 ? screen.width : screen.height) * relative;
      bound = std::max(bound, pixels + half_grid_step);
    }
    if (std::isnan(bound)) bound = infinity;
  }
  return bounds;
}

}  // namespace morphcl
