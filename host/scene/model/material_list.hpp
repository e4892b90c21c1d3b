// The materials of a scene by name: what material_id counts, what Cryptomatte's manifest lists, what `info` prints.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "morphcl/scene.hpp"

namespace morphcl {

// The name of an object's material: its own, else the object's.
const std::string& material_name(const Object& object);

struct MaterialList {
  std::vector<std::string> names;        // distinct, in the order in which the scene's objects first use them
  std::vector<std::uint32_t> of_object;  // for each object of the scene: index into names
};
MaterialList list_materials(const Scene& scene);

}  // namespace morphcl
