// Where a scene's picture shows something, over all its frames.
#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "morphcl/scene.hpp"

namespace morphcl::test {

// The box of all drawn vertices in NDC, and their distances along the view axis.
struct DrawnOutline {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
  double nearest = std::numeric_limits<double>::infinity(), farthest = -std::numeric_limits<double>::infinity();
};

// By projecting every vertex of every frame that some triangle or drawn edge names.
DrawnOutline drawn_outline(const Scene& scene);

// The outline's middle is that of the picture within 1 % of its size, its larger side is 80 % of the picture, and all
// of it lies between near and far. Returns the outline.
DrawnOutline expect_fills(const Scene& scene);

}  // namespace morphcl::test
