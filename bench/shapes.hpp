// The shapes of the benchmark scenes, each with its two states.
#pragma once

#include "bench/scenes.hpp"

namespace morphcl::bench {

// Half-edge 1: six faces of four corners of their own, 12 triangles. State 1 is the cube; state 0 is the pyramid on the
// same base, or else the cube times `first_scale`.
Shape cube_shape(bool pyramid_first, float first_scale);

// A sphere of radius 1, then a cube: six faces of `cells` by `cells` quads, 12 `cells`² triangles, with normals.
Shape sphere_shape(int cells);

// Quads that just cover a picture of this aspect (width / height) seen from the origin along -z, each behind the next
// or in front of it, with normals that vary across each.
Shape layers_shape(int layers, double aspect, bool back_to_front);

// The 12 edges of the pyramid, then of the cube.
Shape lines_shape();

}  // namespace morphcl::bench
