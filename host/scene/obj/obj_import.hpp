// Import of Wavefront .obj: polygons, and morph targets from files of the same topology.
//
// The file becomes one Mesh and one double-sided Object: groups and objects (g, o) are kept together, smoothing groups
// and texture coordinates are ignored. A vertex used with several normals (f v//vn) is split. A file in which any
// corner has no normal is lit flat. Polygons are cut into triangles (host/scene/obj/polygon_triangulation.hpp), while
// Mesh::edges keeps the polygons' own sides. The Kd of the .mtl file is the base colour if all faces use one material.
//
// Errors: cannot_read; bad_input with file and line for numbers that are malformed or not finite in fp32, indices out
// of range, faces with fewer than three corners, and files beyond `limits`.
#pragma once

#include <string>
#include <vector>

#include "host/scene/model/imported_model.hpp"

namespace morphcl {

ImportedModel import_obj(const std::string& path, const ImportLimits& limits = {});

// The neutral mesh with one absolute target a file, named by the file's stem. A target file must have as many `v` as
// the neutral one and the same faces by their `v` indices, else Error(bad_input) naming file and line. A target has
// normals when both files have: the neutral vertex's corners are looked up in the target and their normals averaged,
// because exporters number `vn` anew in every file. Otherwise the target keeps the neutral normals.
ImportedModel import_obj_targets(const std::string& neutral_path, const std::vector<std::string>& target_paths,
                                 const ImportLimits& limits = {});

}  // namespace morphcl
