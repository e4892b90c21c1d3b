// Newell's teapot: 32 bicubic Bezier patches in the classic coordinates (z up, x towards the spout, height 0 to 3.15).
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace morphcl {

// Control points [row][column]; the surface is S(u, v) = sum B_row(v) B_column(u) point[row][column].
struct BezierPatch {
  std::array<std::array<glm::dvec3, 4>, 4> points;
  bool flipped = false;  // dS/dv x dS/du points inwards instead of outwards
};

// In this order: four quarter turns each of rim, upper body, lower body, knob, lid and bottom; then the two halves each
// of the upper handle, lower handle, lower spout and upper spout. Neighbours share their boundary control points
// exactly.
const std::vector<BezierPatch>& teapot_patches();

struct SurfacePoint {
  glm::dvec3 position, normal;  // unit length, outwards
};

// The point at u, v in [0, 1]. Where a row of control points is one point (the poles of knob and bottom), dS/du
// vanishes and the normal is that of its limit, from d2S/dudv.
SurfacePoint evaluate_patch(const BezierPatch& patch, double u, double v);

}  // namespace morphcl
