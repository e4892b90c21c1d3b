// Positions that a frame brings along for an object whose vertices do not follow from its mesh and weights alone.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "anim/elastic_body.hpp"
#include "host/geometry/bounds.hpp"

namespace morphcl {

// They take the place of the mesh's morphed positions: computed in binary64, rounded once. Normals and colours follow
// the weights.
struct DisplacedPositions {
  std::vector<glm::vec3> positions;     // one a vertex of the mesh
  std::array<std::uint64_t, 2> hash{};  // xxh3-128 of them
  Box box;                              // around them
  ElasticMethod method = ElasticMethod::modal;
  std::size_t masses = 0;
};

}  // namespace morphcl
