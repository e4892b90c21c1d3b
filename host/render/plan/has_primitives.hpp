// Whether an object of this mesh has anything to draw.
#pragma once

#include "morphcl/scene.hpp"

namespace morphcl {

inline bool has_primitives(const Object& object, const Mesh& mesh) {
  return !mesh.triangles.empty() || (object.material.shading == Shading::wireframe && !mesh.edges.empty());
}

}  // namespace morphcl
