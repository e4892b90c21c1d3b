// An .obj file as a Mesh, and others of the same topology as its morph targets.
#pragma once

#include <cstdint>
#include <vector>

#include "host/scene/obj/obj_file.hpp"

namespace morphcl {

struct ObjMesh {
  Mesh mesh;
  std::vector<ObjCorner> vertices;             // what each vertex of the mesh is in the file
  std::vector<std::uint32_t> corner_vertices;  // the vertex of each corner in ObjFile::corners
  bool dropped_normals = false;                // the file has normals, but not at every corner
};

// A vertex is a pair of position and normal that some face uses, in the file's order of positions.
ObjMesh make_mesh(const ObjFile& file, ImportBudget& budget);

// `file` as an absolute target of `neutral`, made from `neutral_file`; see obj_import.hpp.
MorphTarget make_target(const ObjFile& file, const ObjFile& neutral_file, const ObjMesh& neutral, ImportBudget& budget);

}  // namespace morphcl
