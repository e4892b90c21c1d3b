#include "host/geometry/teapot_patches.hpp"

namespace morphcl {

namespace {

// A row of a quarter of revolution: radius, the offset of the inner control points along the circle's tangent, height.
struct Ring {
  double radius, tangent, height;
};
using Profile = std::array<Ring, 4>;

// Each profile runs so that the outside lies on its left when it is drawn with the axis at the left edge of the page.
constexpr std::array<Profile, 6> profiles = {{
    {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},  // rim
    {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2.0, 1.12, 1.35}, {2.0, 1.12, 0.9}}},               // upper body
    {{{2.0, 1.12, 0.9}, {2.0, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},               // lower body
    {{{0, 0, 3.15}, {0.8, 0.45, 3.15}, {0, 0, 2.85}, {0.2, 0.112, 2.7}}},                         // knob
    {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}},             // lid
    {{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0}, {0, 0, 0}}},                      // bottom
}};

// One half of a part that is symmetric about the plane y = 0; each row runs from its inner point on that plane out to
// the half-width and back to its outer point on the plane.
struct HalfRow {
  double inner_x, inner_z, outer_x, outer_z, half_width;
};
using HalfTube = std::array<HalfRow, 4>;

constexpr std::array<HalfTube, 4> tubes = {{
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3, 2.25, 0.3},
      {-2.7, 1.8, -3, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3, 1.8, 0.3},
      {-2.7, 1.575, -3, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2, 0.9, -1.9, 0.6, 0.3}}},
    {{{1.7, 1.425, 1.7, 0.6, 0.66},
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
}};

BezierPatch quarter_turn(const BezierPatch& patch) {  // by 90 degrees about z
  BezierPatch turned = patch;
  for (auto& row : turned.points)
    for (glm::dvec3& p : row) p = {0.0 - p.y, p.x, p.z};
  return turned;
}

BezierPatch revolve(const Profile& profile) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const auto [r, t, z] = profile[row];
    patch.points[row] = {{{r, 0, z}, {r, t, z}, {t, r, z}, {0, r, z}}};
  }
  return patch;
}

BezierPatch half_tube(const HalfTube& tube, double side) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const HalfRow& h = tube[row];
    const double y = side * h.half_width;
    patch.points[row] = {
        {{h.inner_x, 0, h.inner_z}, {h.inner_x, y, h.inner_z}, {h.outer_x, y, h.outer_z}, {h.outer_x, 0, h.outer_z}}};
  }
  return patch;
}

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}

std::array<double, 4> bernstein_derivative(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

glm::dvec3 combine(const BezierPatch& patch, const std::array<double, 4>& along_v,
                   const std::array<double, 4>& along_u) {
  glm::dvec3 sum(0.0);
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      sum += along_v[row] * along_u[column] * patch.points[row][column];
  return sum;
}

}  // namespace

const std::vector<BezierPatch>& teapot_patches() {
  static const std::vector<BezierPatch> all = [] {
    std::vector<BezierPatch> patches;
    for (const Profile& profile : profiles) {
      BezierPatch patch = revolve(profile);
      for (int quarter = 0; quarter < 4; ++quarter) {
        patches.push_back(patch);
        patch = quarter_turn(patch);
      }
    }
    for (const HalfTube& tube : tubes)
      for (const double side : {-1.0, 1.0}) {
        patches.push_back(half_tube(tube, side));
        patches.back().flipped = side < 0;
      }
    return patches;
  }();
  return all;
}

SurfacePoint evaluate_patch(const BezierPatch& patch, double u, double v) {
  const auto bu = bernstein(u), bv = bernstein(v), du = bernstein_derivative(u), dv = bernstein_derivative(v);
  const glm::dvec3 along_v = combine(patch, dv, bu);
  glm::dvec3 along_u = combine(patch, bv, du);
  // On a collapsed row the sum above cancels exactly or to rounding; every regular derivative is longer than 0.1.
  constexpr double collapsed_length = 1e-6;
  if (glm::length(along_u) < collapsed_length) along_u = (v < 0.5 ? 1.0 : -1.0) * combine(patch, dv, du);
  const glm::dvec3 normal = glm::normalize(glm::cross(along_v, along_u));
  return {combine(patch, bv, bu), patch.flipped ? -normal : normal};
}

}  // namespace morphcl
