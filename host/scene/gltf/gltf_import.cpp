#include "host/scene/gltf/gltf_import.hpp"

#include <fmt/format.h>

#include "host/scene/gltf/gltf_accessor.hpp"
#include "host/scene/gltf/gltf_animation.hpp"
#include "host/scene/gltf/gltf_document.hpp"
#include "host/scene/gltf/gltf_mesh.hpp"
#include "host/scene/gltf/gltf_nodes.hpp"
#include "host/scene/gltf/gltf_view.hpp"
#include "host/scene/gltf/gltf_warnings.hpp"

namespace morphcl {

namespace {

// The mesh of each node, -1 without; also checks the other references that a node may hold.
std::vector<int> node_meshes(const GltfDocument& document) {
  std::vector<int> meshes;
  for (std::size_t i = 0; i < document.count("nodes"); ++i) {
    const GltfValue node = document.element("nodes", i);
    meshes.push_back(node.index("mesh", document.count("meshes"), "meshes"));
    node.index("skin", document.count("skins"), "skins");
  }
  return meshes;
}

// A mesh that no drawn node shows is checked, not decoded.
std::vector<GltfMesh> read_meshes(const GltfDocument& document, const GltfAccessors& accessors,
                                  const std::vector<int>& mesh_of_node, const std::vector<bool>& drawn,
                                  std::vector<Mesh>& meshes, GltfWarnings& warnings) {
  std::vector<GltfMesh> result(document.count("meshes"));
  std::vector<bool> shown(result.size());
  for (std::size_t i = 0; i < mesh_of_node.size(); ++i)
    if (mesh_of_node[i] >= 0 && drawn[i]) shown[static_cast<std::size_t>(mesh_of_node[i])] = true;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = read_mesh(document, accessors, i, shown[i], meshes, warnings);
  return result;
}

std::vector<double> node_weights(const GltfValue& node, const GltfMesh& mesh) {
  const auto weights = node.find("weights");
  return weights ? weights->numbers(mesh.weights.size()) : mesh.weights;
}

void add_objects(const GltfDocument& document, std::size_t node, const GltfMesh& mesh,
                 const GltfSampler& animated_weights, ImportedModel& model) {
  const GltfValue json = document.element("nodes", node);
  MorphWeights weights{node_weights(json, mesh), {}};
  if (!animated_weights.track.empty()) weights.tracks.push_back({0, animated_weights.track});
  for (std::size_t p = 0; p < mesh.meshes.size(); ++p) {
    Object object;
    const std::string& name = model.nodes[node].name;
    object.name = mesh.primitive_count == 1 ? name : fmt::format("{}.{}", name, p);
    object.mesh = mesh.meshes[p];
    object.node = static_cast<int>(node);
    object.material = mesh.materials[p];
    document.budget().charge(1, sizeof(Object) + object.name.size(), json.place());
    document.budget().charge(weights.weights.size(), sizeof(double), json.place());
    document.budget().charge(animated_weights.bytes, 1, json.place());
    object.morph = weights;
    model.objects.push_back(std::move(object));
  }
}

}  // namespace

ImportedModel import_gltf(const std::string& path, const TimeBase& time, const ImportLimits& limits) {
  const GltfDocument document(path, limits);
  const GltfAccessors accessors(document);
  GltfWarnings warnings;
  warnings.survey(document);

  ImportedModel model;
  GltfNodes nodes = read_nodes(document, warnings);
  const std::vector<int> mesh_of_node = node_meshes(document);
  const std::vector<GltfMesh> meshes =
      read_meshes(document, accessors, mesh_of_node, nodes.drawn, model.meshes, warnings);
  std::vector<std::size_t> node_targets(nodes.nodes.size());
  for (std::size_t i = 0; i < node_targets.size(); ++i)
    if (mesh_of_node[i] >= 0) node_targets[i] = meshes[static_cast<std::size_t>(mesh_of_node[i])].weights.size();
  const GltfAnimations animations = read_animations(document, accessors, time, node_targets, nodes, warnings);

  model.camera = read_camera(document, nodes, warnings);
  model.lights = read_lights(document, nodes, warnings);
  model.nodes = std::move(nodes.nodes);
  for (std::size_t i = 0; i < mesh_of_node.size(); ++i)
    if (mesh_of_node[i] >= 0 && nodes.drawn[i])
      add_objects(document, i, meshes[static_cast<std::size_t>(mesh_of_node[i])], animations.node_weights[i], model);
  model.duration_seconds = animations.duration_seconds;
  model.warnings = warnings.lines();
  model.content_hash = document.content_hash();
  return model;
}

}  // namespace morphcl
