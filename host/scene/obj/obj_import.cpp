#include "host/scene/obj/obj_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "host/scene/model/content_hash.hpp"
#include "host/scene/model/input_file.hpp"
#include "host/scene/obj/obj_material.hpp"
#include "host/scene/obj/obj_mesh.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

ObjFile read_obj(const std::string& path, const ImportLimits& limits, ImportBudget& budget, ContentHash& hash) {
  const std::string text = read_input_file(path, budget.left());
  budget.charge(text.size(), 1, path);
  hash.add(text);
  return parse_obj(text, path, limits, budget);
}

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

void warn(const ObjFile& file, const ObjMesh& mesh, std::vector<std::string>& warnings) {
  std::string names;
  for (const std::string& what : file.not_drawn) names += (names.empty() ? "" : ", ") + what;
  if (!names.empty()) warnings.push_back("not drawn: " + names);
  if (mesh.dropped_normals)
    warnings.push_back(
        fmt::format("{}: some face corners have no normal, so the faces are lit flat", printable(file.path)));
}

}  // namespace

ImportedModel import_obj(const std::string& path, const ImportLimits& limits) {
  return import_obj_targets(path, {}, limits);
}

ImportedModel import_obj_targets(const std::string& neutral_path, const std::vector<std::string>& target_paths,
                                 const ImportLimits& limits) {
  ImportBudget budget(limits.max_decoded_bytes);
  ContentHash hash;
  const ObjFile neutral = read_obj(neutral_path, limits, budget, hash);
  ObjMesh made = make_mesh(neutral, budget);
  ImportedModel model;
  warn(neutral, made, model.warnings);

  Object object;
  object.name = stem(neutral_path);
  object.material.double_sided = true;  // the format does not say which side is the outer one
  object.material.shading = made.mesh.normals.empty() ? Shading::flat : Shading::smooth;
  if (const auto color = diffuse_color(neutral, limits, budget, hash, model.warnings))
    object.material.base_color = glm::dvec4(*color, 1.0);

  for (const std::string& path : target_paths) {
    MorphTarget target = make_target(read_obj(path, limits, budget, hash), neutral, made, budget);
    target.name = stem(path);
    for (const MorphTarget& other : made.mesh.targets)
      if (other.name == target.name)
        throw Error(ErrorKind::bad_input, path, fmt::format("two morph targets would be named '{}'", target.name));
    made.mesh.targets.push_back(std::move(target));
  }

  made.mesh.name = object.name;
  Node node;
  node.name = object.name;
  object.morph.weights.assign(made.mesh.targets.size(), 0.0);
  model.nodes.push_back(std::move(node));
  model.objects.push_back(std::move(object));
  model.meshes.push_back(std::move(made.mesh));
  model.content_hash = hash.hex();
  return model;
}

}  // namespace morphcl
