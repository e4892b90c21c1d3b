// The .mtl files of an .obj file: what of its materials is drawn.
//
// They only matter to the looks, so nothing in them is an error: `warnings` says what is missing, mended or not drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/scene/model/content_hash.hpp"
#include "host/scene/obj/obj_file.hpp"

namespace morphcl {

struct ObjMaterial {
  std::optional<glm::dvec3> diffuse;  // Kd, taken as scene-linear, from 0 to 1
  double alpha = 1;                   // d, or 1 - Tr
};

// One for each of file.materials: the first of its name in the libraries. Where the file names a library, a material
// that is in none is a warning.
//
// A library is looked for under the name that is given, then with '/' for '\\', then as a file of its base name beside
// the model. An mtllib statement may give several names; one with blanks is tried as a whole first. What lies outside
// the model's folder is not read unless `limits` allow it.
std::vector<ObjMaterial> read_materials(const ObjFile& file, const ImportLimits& limits, ImportBudget& budget,
                                        ContentHash& hash, std::vector<std::string>& warnings);

}  // namespace morphcl
