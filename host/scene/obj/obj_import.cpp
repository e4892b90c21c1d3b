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
  const std::string text = read_input_file(path, budget.left_to_read());
  require_utf8(text, path);
  budget.charge_file(path, text.size(), path);
  hash.add(text);
  return parse_obj(text, path, limits, budget);
}

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

void tell(const ObjFile& file, std::vector<std::string>& warnings) {
  std::string names;
  for (const std::string& what : file.not_drawn) names += (names.empty() ? "" : ", ") + what;
  if (!names.empty()) warnings.push_back("not drawn: " + names);
  warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
}

Material material_of(const ObjFile& file, const ObjPart& part, const std::vector<ObjMaterial>& materials) {
  Material material;
  material.double_sided = true;  // the format does not say which side is the outer one
  if (part.material >= 0) material.name = file.materials[static_cast<std::size_t>(part.material)];
  const auto diffuse = part.material < 0 ? std::nullopt : materials[static_cast<std::size_t>(part.material)].diffuse;
  if (diffuse)
    material.base_color = glm::dvec4(*diffuse, 1.0);
  else if (!file.colors.empty())
    material.base_color = glm::dvec4(1.0);  // vertex colours are what they say
  if (part.material >= 0) material.base_color.a = materials[static_cast<std::size_t>(part.material)].alpha;
  return material;
}

bool is_seen(const ObjPart& part, const std::vector<ObjMaterial>& materials) {
  return part.material < 0 || materials[static_cast<std::size_t>(part.material)].alpha > 0;
}

struct ObjTarget {
  ObjFile file;
  std::string name;
};

std::vector<ObjTarget> read_targets(const std::vector<std::string>& paths, const ObjFile& neutral,
                                    const ImportLimits& limits, ImportBudget& budget, ContentHash& hash) {
  std::vector<ObjTarget> targets;
  for (const std::string& path : paths) {
    ObjTarget target{read_obj(path, limits, budget, hash), stem(path)};
    check_topology(target.file, neutral);
    for (const ObjTarget& other : targets)
      if (other.name == target.name)
        throw Error(ErrorKind::bad_input, path, fmt::format("two morph targets would be named '{}'", target.name));
    targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace

ImportedModel import_obj(const std::string& path, const ImportLimits& limits) {
  return import_obj_targets(path, {}, limits);
}

ImportedModel import_obj_targets(const std::string& neutral_path, const std::vector<std::string>& target_paths,
                                 const ImportLimits& limits) {
  ImportBudget budget(limits.max_decoded_bytes, limits.stop);
  ContentHash hash;
  const ObjFile neutral = read_obj(neutral_path, limits, budget, hash);
  if (neutral.faces.empty() && neutral.small_faces == 0 && neutral.not_drawn.empty())
    throw Error(ErrorKind::bad_input, neutral_path, "holds no faces; a Wavefront .obj file with 'f' lines is needed");
  ImportedModel model;
  tell(neutral, model.warnings);
  const std::vector<ObjMaterial> materials = read_materials(neutral, limits, budget, hash, model.warnings);
  const std::vector<ObjTarget> targets = read_targets(target_paths, neutral, limits, budget, hash);
  for (const ObjTarget& target : targets)
    model.warnings.insert(model.warnings.end(), target.file.warnings.begin(), target.file.warnings.end());

  const std::vector<ObjPart> parts = split_by_material(neutral, budget);
  for (const ObjPart& part : parts) {
    if (!is_seen(part, materials)) continue;
    ObjMesh made = make_mesh(neutral, part, budget);
    for (const ObjTarget& target : targets) {
      made.mesh.targets.push_back(make_target(target.file, part, made, budget));
      made.mesh.targets.back().name = target.name;
    }
    Object object;
    object.name = stem(neutral_path);
    if (parts.size() > 1 && part.material >= 0)
      object.name += '.' + neutral.materials[static_cast<std::size_t>(part.material)];
    object.mesh = static_cast<int>(model.meshes.size());
    object.material = material_of(neutral, part, materials);
    object.morph.weights.assign(targets.size(), 0.0);
    made.mesh.name = object.name;
    budget.charge(1, sizeof(Object) + sizeof(Mesh) + 2 * object.name.size(), neutral_path);
    model.objects.push_back(std::move(object));
    model.meshes.push_back(std::move(made.mesh));
  }
  Node node;
  node.name = stem(neutral_path);
  model.nodes.push_back(std::move(node));
  model.content_hash = hash.hex();
  model.inputs = budget.inputs();
  return model;
}

}  // namespace morphcl
