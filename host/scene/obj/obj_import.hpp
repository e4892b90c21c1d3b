// Import of Wavefront .obj: polygons, and morph targets from files of the same topology.
//
// Each material that the faces use becomes one Mesh and one double-sided Object, in the order of their first faces:
// "car.paint"; faces of one material, or of none, are called as the file. Groups and objects (g, o) and smoothing
// groups are ignored. A vertex used with several normals or texture coordinates (f v/vt/vn) is split. Polygons are cut
// into triangles (host/scene/obj/polygon_triangulation.hpp), while Mesh::edges keeps the polygons' own sides. The base
// colour is the material's Kd, else the default, which is white where vertices have colours.
//
// Strict about geometry: cannot_read; bad_input with file and line for coordinates that are malformed or not finite in
// fp32, vertex indices out of range, and files beyond `limits`.
//
// Tolerant about looks, each with a warning: a file in which any corner has no normal, or one that is missing, zero or
// no number, is lit flat; a corner without texture coordinates has 0, 0; for colours see obj_colors.hpp, for materials
// obj_material.hpp. Faces of fewer than three corners are left out.
#pragma once

#include <string>
#include <vector>

#include "host/scene/model/imported_model.hpp"

namespace morphcl {

ImportedModel import_obj(const std::string& path, const ImportLimits& limits = {});

// The neutral meshes with one absolute target a file, named by the file's stem. A target file must have as many `v` as
// the neutral one, and no faces or the same by their `v` indices, else Error(bad_input) naming file and line. A target
// has normals when both files have: the neutral vertex's corners are looked up in the target and their normals
// averaged, because exporters number `vn` anew in every file. Otherwise the target keeps the neutral normals.
ImportedModel import_obj_targets(const std::string& neutral_path, const std::vector<std::string>& target_paths,
                                 const ImportLimits& limits = {});

}  // namespace morphcl
