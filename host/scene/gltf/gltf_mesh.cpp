#include "host/scene/gltf/gltf_mesh.hpp"

#include <fmt/format.h>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

std::size_t target_count(const GltfValue& primitive) {
  const auto targets = primitive.find("targets");
  return targets ? targets->size() : 0;
}

// The specification leaves names to convention: where they do not fit the targets, all are numbered.
std::vector<std::string> target_names(const GltfDocument& document, const GltfValue& mesh, std::size_t count,
                                      GltfWarnings& warnings) {
  document.budget().charge(count, sizeof(std::string), mesh.place());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(fmt::format("target{}", i));
  try {
    const auto extras = mesh.find("extras");
    const auto given = extras ? extras->find("targetNames") : std::nullopt;
    if (!given) return names;
    if (given->size() != count) given->fail("has not one name a target");
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) texts.push_back((*given)[i].text());
    return texts;
  } catch (const Error&) {
    if (count > 0) warnings.say(fmt::format("{}: extras.targetNames does not fit; targets are numbered", mesh.place()));
    return names;
  }
}

}  // namespace

GltfMesh read_mesh(const GltfDocument& document, const GltfAccessors& accessors, std::size_t index, bool decode,
                   std::vector<Mesh>& meshes, GltfWarnings& warnings) {
  const GltfValue json = document.element("meshes", index);
  const GltfValue primitives = json.get("primitives");
  GltfMesh result;
  result.primitive_count = primitives.size();
  const std::size_t targets = result.primitive_count > 0 ? target_count(primitives[0]) : 0;
  for (std::size_t p = 1; p < result.primitive_count; ++p)
    if (const std::size_t count = target_count(primitives[p]); count != targets)
      primitives[p].fail(
          fmt::format("has {} morph targets, primitives[0] has {}; all must have as many", count, targets));

  result.weights.assign(targets, 0.0);
  if (const auto weights = json.find("weights")) result.weights = weights->numbers(targets);

  const std::vector<std::string> names = target_names(document, json, targets, warnings);
  const std::string name = warnings.read_name(json, fmt::format("mesh{}", index));
  for (std::size_t p = 0; p < result.primitive_count; ++p) {
    std::optional<GltfPrimitive> primitive =
        read_primitive(document, accessors, primitives[p], names, decode, warnings);
    if (!primitive) continue;
    primitive->mesh.name = result.primitive_count == 1 ? name : fmt::format("{}.{}", name, p);
    document.budget().charge(1, sizeof(Mesh) + primitive->mesh.name.size(), json.place());
    result.meshes.push_back(static_cast<int>(meshes.size()));
    result.materials.push_back(primitive->material);
    meshes.push_back(std::move(primitive->mesh));
  }
  return result;
}

}  // namespace morphcl
