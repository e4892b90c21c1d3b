// The .mtl files of an .obj file: the diffuse colour, as far as one colour can stand for the model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/scene/model/content_hash.hpp"
#include "host/scene/obj/obj_file.hpp"

namespace morphcl {

// The Kd of the one material that all faces of `file` use, taken as scene-linear. Nothing when there is no such
// material; `warnings` says why where a colour is lost. A library that cannot be read is a warning; one outside the
// model's folder and malformed numbers are Error(bad_input).
std::optional<glm::dvec3> diffuse_color(const ObjFile& file, const ImportLimits& limits, ImportBudget& budget,
                                        ContentHash& hash, std::vector<std::string>& warnings);

}  // namespace morphcl
