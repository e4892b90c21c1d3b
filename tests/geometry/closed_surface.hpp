// What tests ask of a surface, found from its triangles alone.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "morphcl/mesh.hpp"

namespace morphcl::testing {

// The surface with vertices at the same place (exactly) made one and triangles without area left out.
struct WeldedSurface {
  std::vector<glm::dvec3> points;
  std::vector<std::array<int, 3>> triangles;
};
WeldedSurface weld(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles);

// How often each directed edge occurs.
std::map<std::array<int, 2>, int> directed_edges(const WeldedSurface& surface);

// Every directed edge occurs once and so does its reverse: closed, and wound one way round.
bool is_closed(const WeldedSurface& surface);

int euler_characteristic(const WeldedSurface& surface);  // V - E + F
double signed_volume(const WeldedSurface& surface);      // > 0 when wound counter-clockwise seen from outside

}  // namespace morphcl::testing
