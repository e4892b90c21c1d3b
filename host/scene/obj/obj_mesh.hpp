// The faces of an .obj file that share a material as a Mesh, and others of the same topology as its morph targets.
#pragma once

#include <cstdint>
#include <vector>

#include "host/scene/obj/obj_file.hpp"

namespace morphcl {

struct ObjPart {
  std::int32_t material = -1;        // index into ObjFile::materials; -1: none
  std::vector<std::uint32_t> faces;  // indices into ObjFile::faces, increasing
};

// One part a material, in the order of their first faces.
std::vector<ObjPart> split_by_material(const ObjFile& file, ImportBudget& budget);

struct ObjMesh {
  Mesh mesh;
  std::vector<ObjCorner> vertices;             // what each vertex of the mesh is in the file
  std::vector<std::uint32_t> corner_vertices;  // the vertex of each corner of the part's faces
};

// A vertex is what some face of the part uses together of position, normal and texture coordinates, in the file's order
// of positions.
ObjMesh make_mesh(const ObjFile& file, const ObjPart& part, ImportBudget& budget);

// Error(bad_input) unless `file` can be a target of `neutral`; see obj_import.hpp.
void check_topology(const ObjFile& file, const ObjFile& neutral);

// `file`, which has passed that check, as an absolute target of the mesh that a part of the neutral file became.
MorphTarget make_target(const ObjFile& file, const ObjPart& part, const ObjMesh& neutral, ImportBudget& budget);

}  // namespace morphcl
