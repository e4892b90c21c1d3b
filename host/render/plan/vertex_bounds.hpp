// How far vertices may lie from where exact arithmetic has them on the screen, known before they are computed.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "host/geometry/bounds.hpp"
#include "host/render/frame/vertex_accuracy.hpp"

namespace morphcl {

// What is known of a draw.
struct VertexTerms {
  glm::dmat4 object_to_clip;  // in fp64
  glm::dmat4 magnitudes;      // the product of the absolute values of the matrices whose product that is
  Box box;                    // of the morphed mesh
  glm::dvec3 plain_terms;     // sum of the magnitudes of the products that a morphed position adds up
  glm::dvec3 pivot_terms;     // the same relative to the pivot
  glm::dvec3 pivot;
  int targets;  // that move positions
};

struct ScreenOfVertices {
  int width, height;       // pixels
  float guard_x, guard_y;  // |x| <= guard w of vertices that are not clipped
  float near_w;            // w >= near_w of those
};

// Pixels in x or y, the larger, of each form: of every vertex that is not clipped, from its place by the fp64 matrices
// and weights in exact arithmetic to the grid of 1/256 pixel that it is snapped to, half of whose spacing is part of
// the bound. Infinity where nothing is known.
//
// Method: with u = 2^-24 and the terms t = sum |m| |p| of a row of the matrix, fp32 rounds the matrix and three steps,
// 4 u t; a position is rounded twice for every target, and a weight once. Two floats do 16 u^2 t and round the result.
// Errors of x and w, e_x and e_w, move the picture of a vertex by at most (e_x + |x / w| e_w) / w.
std::array<double, 3> vertex_error_bounds(const VertexTerms& terms, const ScreenOfVertices& screen);

}  // namespace morphcl
