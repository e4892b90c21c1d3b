#include "host/scene/gltf/gltf_import.hpp"

#include <fmt/format.h>

#include "host/scene/gltf/gltf_accessor.hpp"
#include "host/scene/gltf/gltf_animation.hpp"
#include "host/scene/gltf/gltf_document.hpp"
#include "host/scene/gltf/gltf_mesh.hpp"
#include "host/scene/gltf/gltf_nodes.hpp"
#include "host/scene/gltf/gltf_view.hpp"
#include "host/scene/gltf/gltf_warnings.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

struct NodeMesh {
  int mesh = -1;         // -1: none
  bool skinned = false;  // joints place it, not the node
};

std::vector<NodeMesh> node_meshes(const GltfDocument& document) {
  std::vector<NodeMesh> meshes;
  for (std::size_t i = 0; i < document.count("nodes"); ++i) {
    const GltfValue node = document.element("nodes", i);
    const int mesh = node.index("mesh", document.count("meshes"), "meshes");
    const int skin = node.index("skin", document.count("skins"), "skins");
    meshes.push_back({mesh, mesh >= 0 && skin >= 0});
  }
  return meshes;
}

// The scene that is drawn, -1 when the file has none; all are listed in `parts`.
int choose_scene(const GltfDocument& document, const std::optional<std::string>& wanted, std::vector<ModelPart>& parts,
                 GltfWarnings& warnings) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < document.count("scenes"); ++i)
    names.push_back(warnings.read_name(document.element("scenes", i), ""));
  const int own = document.root().index("scene", names.size(), "scenes");
  int chosen = own < 0 && !names.empty() ? 0 : own;
  if (wanted) chosen = static_cast<int>(choose(names, *wanted, "scene", document.path()));
  for (std::size_t i = 0; i < names.size(); ++i)
    parts.push_back(
        {document.path(), ModelPart::Kind::scene, static_cast<int>(i), names[i], 0, static_cast<int>(i) == chosen});
  return chosen;
}

// A mesh that no drawn node shows is checked, not decoded.
std::vector<GltfMesh> read_meshes(const GltfDocument& document, const GltfAccessors& accessors,
                                  const std::vector<NodeMesh>& mesh_of_node, const std::vector<bool>& drawn,
                                  std::vector<Mesh>& meshes, GltfWarnings& warnings) {
  std::vector<GltfMesh> result(document.count("meshes"));
  std::vector<bool> shown(result.size());
  for (std::size_t i = 0; i < mesh_of_node.size(); ++i)
    if (mesh_of_node[i].mesh >= 0 && drawn[i]) shown[static_cast<std::size_t>(mesh_of_node[i].mesh)] = true;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = read_mesh(document, accessors, i, shown[i], meshes, warnings);
  return result;
}

std::vector<double> node_weights(const GltfValue& node, const GltfMesh& mesh) {
  const auto weights = node.find("weights");
  return weights ? weights->numbers(mesh.weights.size()) : mesh.weights;
}

// `stand`: the node that they hang from.
void add_objects(const GltfDocument& document, std::size_t node, int stand, const GltfMesh& mesh,
                 const GltfSampler& animated_weights, ImportedModel& model) {
  const GltfValue json = document.element("nodes", node);
  MorphWeights weights{node_weights(json, mesh), {}};
  if (!animated_weights.track.empty()) weights.tracks.push_back({0, animated_weights.track});
  for (std::size_t p = 0; p < mesh.meshes.size(); ++p) {
    Object object;
    const std::string& name = model.nodes[node].name;
    object.name = mesh.primitive_count == 1 ? name : fmt::format("{}.{}", name, p);
    object.mesh = mesh.meshes[p];
    object.node = stand;
    object.material = mesh.materials[p];
    document.budget().charge(1, sizeof(Object) + object.name.size(), json.place());
    document.budget().charge(weights.weights.size(), sizeof(double), json.place());
    document.budget().charge(animated_weights.bytes, 1, json.place());
    object.morph = weights;
    model.objects.push_back(std::move(object));
  }
}

ImportedModel import_parts(const std::string& path, const TimeBase& time, const ImportLimits& limits,
                           const ModelChoice& choice, bool meshes_too) {
  const GltfDocument document(path, limits);
  const GltfAccessors accessors(document);
  GltfWarnings warnings;
  warnings.survey(document);

  ImportedModel model;
  const int scene = choose_scene(document, choice.scene, model.parts, warnings);
  GltfNodes nodes = read_nodes(document, scene, warnings);
  const std::vector<NodeMesh> mesh_of_node = node_meshes(document);
  const std::vector<bool> shown = meshes_too ? nodes.drawn : std::vector<bool>(nodes.drawn.size());
  const std::vector<GltfMesh> meshes = read_meshes(document, accessors, mesh_of_node, shown, model.meshes, warnings);
  std::vector<std::size_t> node_targets(nodes.nodes.size());
  for (std::size_t i = 0; i < node_targets.size(); ++i)
    if (mesh_of_node[i].mesh >= 0)
      node_targets[i] = meshes[static_cast<std::size_t>(mesh_of_node[i].mesh)].weights.size();
  const GltfAnimations animations =
      read_animations(document, accessors, time, node_targets, choice.animation, nodes, model.parts, warnings);

  if (const auto camera = read_camera(document, nodes, choice.camera, model.parts, warnings)) {
    model.camera = camera->camera;
    model.camera_aspect = camera->aspect;
  }
  model.lights = read_lights(document, nodes, warnings);
  model.nodes = std::move(nodes.nodes);
  int origin = -1;  // the node of skinned meshes
  for (std::size_t i = 0; i < mesh_of_node.size(); ++i) {
    const auto& [mesh, skinned] = mesh_of_node[i];
    if (mesh < 0 || !shown[i]) continue;
    if (skinned && origin < 0) {
      origin = static_cast<int>(model.nodes.size());
      model.nodes.emplace_back().name = "skinned";
      warnings.say("skins are not drawn: a skinned mesh stands unmoved at the origin, where its vertices are");
    }
    add_objects(document, i, skinned ? origin : static_cast<int>(i), meshes[static_cast<std::size_t>(mesh)],
                animations.node_weights[i], model);
  }
  model.duration_seconds = animations.duration_seconds;
  model.warnings = warnings.lines();
  model.content_hash = document.content_hash();
  model.inputs = document.budget().inputs();
  return model;
}

}  // namespace

ImportedModel import_gltf(const std::string& path, const TimeBase& time, const ImportLimits& limits,
                          const ModelChoice& choice) {
  return import_parts(path, time, limits, choice, true);
}

ImportedModel import_gltf_camera(const std::string& path, const TimeBase& time, const ImportLimits& limits,
                                 const ModelChoice& choice) {
  ImportedModel model = import_parts(path, time, limits, choice, false);
  if (!model.camera) throw Error(ErrorKind::bad_input, path, "holds no camera that is drawn");
  return model;
}

}  // namespace morphcl
