// The contents of an .obj file as they stand: positions, normals, texture coordinates and faces with their own
// numbering.
//
// Numbers are read with std::from_chars, not through tinyobjloader, whose numbers are not correctly rounded; it serves
// as the cross-check in the tests.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/model/import_budget.hpp"
#include "host/scene/model/imported_model.hpp"

namespace morphcl {

struct ObjCorner {
  std::uint32_t position = 0;
  std::int32_t normal = -1;  // -1: none
  std::int32_t uv = -1;      // -1: none. Corners with equal coordinates have the same
};

struct ObjFace {
  std::uint32_t first = 0, count = 0;  // of ObjFile::corners
  std::uint32_t line = 0;
  std::int32_t material = -1;  // index into ObjFile::materials, -1 before the first usemtl
};

struct ObjFile {
  std::string path;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> colors;   // from 0 to 1, one a position; or empty
  std::vector<glm::vec3> normals;  // of a length above 0; empty unless every corner has one
  std::vector<glm::vec2> uvs;      // texture coordinates (vt), v up; empty unless some corner has them
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;                   // may be empty
  std::vector<std::string> materials;           // names of usemtl, each once
  std::vector<std::string> material_libraries;  // what follows mtllib: a name, or several
  std::size_t small_faces = 0;                  // left out, as they have fewer than 3 corners
  std::vector<std::string> not_drawn;           // "lines", "statement surf"
  std::vector<std::string> warnings;            // what was wrong and only matters to the looks: left out or mended
};

// Error(bad_input) at "path:line"; see obj_import.hpp. `text` is the file's content.
ObjFile parse_obj(std::string_view text, const std::string& path, const ImportLimits& limits, ImportBudget& budget);

}  // namespace morphcl
