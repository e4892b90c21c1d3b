#include "host/scene/obj/obj_material.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/scene/model/input_file.hpp"
#include "host/scene/obj/obj_text.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t told_materials = 8, told_name = 60;

std::string names_of(const std::vector<std::string>& materials) {
  std::string names;
  for (std::size_t i = 0; i < std::min(materials.size(), told_materials); ++i)
    names += (i > 0 ? ", " : "") + printable(materials[i].substr(0, told_name));
  if (materials.size() > told_materials) names += fmt::format(" and {} more", materials.size() - told_materials);
  return names;
}

struct Library {
  std::optional<glm::dvec3> diffuse;
  bool textured = false;
};

// The material `name` of a library; the first one of that name counts.
Library read_library(std::string_view text, const std::string& path, std::string_view name) {
  Library result;
  ObjStatements statements(text);
  bool inside = false, done = false;
  while (statements.next() && !done) {
    const std::string_view keyword = statements.keyword();
    if (keyword == "newmtl") {
      done = inside;
      inside = !done && statements.remainder() == name;
    } else if (inside && keyword.starts_with("map_")) {
      result.textured = true;
    } else if (inside && keyword == "Kd") {
      const std::string place = fmt::format("{}:{}", path, statements.line());
      std::string_view word = statements.word();
      if (word == "xyz" || word == "spectral") continue;
      glm::dvec3 color;
      for (int c = 0; c < 3; ++c, word = statements.word()) {
        // One number stands for all three.
        if (word.empty() && c > 0) {
          color[c] = color[0];
          continue;
        }
        const std::optional<float> value = parse_float(word);
        if (!value || *value < 0 || *value > 1)
          throw Error(ErrorKind::bad_input, place,
                      fmt::format("'{}' is not a part of a colour, from 0 to 1", word.substr(0, told_name)));
        color[c] = *value;
      }
      result.diffuse = color;
    }
  }
  return result;
}

}  // namespace

std::optional<glm::dvec3> diffuse_color(const ObjFile& file, const ImportLimits& limits, ImportBudget& budget,
                                        ContentHash& hash, std::vector<std::string>& warnings) {
  if (file.materials.empty()) return std::nullopt;
  const std::int32_t material = file.faces.front().material;
  const bool one =
      std::all_of(file.faces.begin(), file.faces.end(), [&](const ObjFace& face) { return face.material == material; });
  if (!one) {
    warnings.push_back(fmt::format("{}: all faces are drawn in one colour; the file has the materials {}",
                                   printable(file.path), names_of(file.materials)));
    return std::nullopt;
  }
  if (material < 0) return std::nullopt;
  const std::string& name = file.materials[static_cast<std::size_t>(material)];
  for (const std::string& library : file.material_libraries) {
    const std::string path = confined_path(file.path, library, limits.allow_outside, file.path);
    std::string text;
    try {
      text = read_input_file(path, budget.left());
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::cannot_read) throw;
      warnings.push_back(fmt::format("{}; the default colour is used", error.what()));
      continue;
    }
    budget.charge(text.size(), 1, path);
    hash.add(text);
    const Library found = read_library(text, path, name);
    if (found.textured) warnings.push_back("not drawn: textures");
    if (found.diffuse) return found.diffuse;
  }
  return std::nullopt;
}

}  // namespace morphcl
