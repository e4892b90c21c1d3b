// Meshes as the morph targets of another one.
#pragma once

#include <string>

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/mesh.hpp"

namespace morphcl {

// Gives `base` an absolute target of the name that has the positions of `shape`, and its normals and colours where both
// have them. Error(bad_input) at `place`: another number of vertices or triangles (both counts of both are told),
// triangles that join other vertices, or a name that a target has already.
void add_shape(const Mesh& shape, const std::string& name, const ShotValue& place, Mesh& base);

}  // namespace morphcl
