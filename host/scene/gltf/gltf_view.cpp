#include "host/scene/gltf/gltf_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/scene/model/model_choice.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

double positive(const GltfValue& json) {
  const double value = json.number();
  if (!(value > 0)) json.fail(fmt::format("is {}; it must be greater than 0", value));
  return value;
}

Projection read_perspective(const GltfValue& json) {
  Perspective lens;
  const GltfValue yfov = json.get("yfov");
  const double angle = positive(yfov);
  if (!(angle < std::numbers::pi)) yfov.fail(fmt::format("is {}; it must be less than pi", angle));
  lens.fovy_degrees = angle * (180.0 / std::numbers::pi);
  lens.near = positive(json.get("znear"));
  lens.far = std::numeric_limits<double>::infinity();
  if (const auto far = json.find("zfar")) {
    lens.far = positive(*far);
    if (!(lens.far > lens.near))
      far->fail(fmt::format("is {}; it must be greater than znear, {}", lens.far, lens.near));
  }
  return lens;
}

Projection read_orthographic(const GltfValue& json) {
  const double x = positive(json.get("xmag")), y = positive(json.get("ymag"));
  const double near = json.get("znear").number(), far = json.get("zfar").number();
  if (!(near >= 0)) json.get("znear").fail(fmt::format("is {}; it must not be negative", near));
  if (!(far > near)) json.get("zfar").fail(fmt::format("is {}; it must be greater than znear, {}", far, near));
  return Orthographic{-x, x, -y, y, near, far, Fit::widen};
}

Projection read_projection(const GltfValue& json) {
  const GltfValue type = json.get("type");
  if (type.text() == "perspective") return read_perspective(json.get("perspective"));
  if (type.text() == "orthographic") return read_orthographic(json.get("orthographic"));
  type.fail(fmt::format("is '{}'; perspective or orthographic are types", type.text()));
}

// It only matters to how much the image shows.
std::optional<double> authored_aspect(const GltfValue& camera, GltfWarnings& warnings) {
  const auto perspective = camera.find("perspective");
  if (!perspective) return std::nullopt;
  try {
    const auto aspect = perspective->find("aspectRatio");
    return aspect ? std::optional(positive(*aspect)) : std::nullopt;
  } catch (const Error& error) {
    warnings.say(fmt::format("{}; the image's is used", error.what()));
    return std::nullopt;
  }
}

// The camera of each node, -1 without.
std::vector<int> node_cameras(const GltfDocument& document, std::size_t node_count) {
  std::vector<int> cameras;
  for (std::size_t i = 0; i < node_count; ++i)
    cameras.push_back(document.element("nodes", i).index("camera", document.count("cameras"), "cameras"));
  return cameras;
}

int find_camera(const std::vector<std::string>& names, const std::string& wanted, const GltfNodes& nodes,
                const std::vector<int>& camera_of_node, const GltfDocument& document) {
  if (std::find(names.begin(), names.end(), wanted) == names.end())
    for (std::size_t i = 0; i < camera_of_node.size(); ++i)
      if (camera_of_node[i] >= 0 && nodes.nodes[i].name == wanted) return camera_of_node[i];
  return static_cast<int>(choose(names, wanted, "camera", document.path()));
}

// The array of the extension's lights in the file's root.
std::optional<GltfValue> light_array(const GltfDocument& document) {
  const auto extensions = document.root().find("extensions");
  const auto extension = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
  return extension ? std::optional(extension->get("lights")) : std::nullopt;
}

std::optional<Light> read_light(const GltfValue& json, const glm::dmat4& to_world, GltfWarnings& warnings) {
  const GltfValue type = json.get("type");
  if (type.text() == "spot") {
    warnings.not_drawn("spot lights");
    return std::nullopt;
  }
  if (type.text() != "directional" && type.text() != "point")
    type.fail(fmt::format("is '{}'; directional, point or spot are types", type.text()));
  Light light;
  const double intensity = json.number("intensity", 1.0);
  if (!(intensity >= 0)) json.get("intensity").fail(fmt::format("is {}; it must not be negative", intensity));
  if (const auto color = json.find("color")) {
    const std::vector<double> c = color->numbers(3);
    light.color = {c[0], c[1], c[2]};
  }
  light.color *= intensity / std::numbers::pi;
  if (type.text() == "point") {
    light.kind = LightKind::point;
    light.falloff = true;
    light.vector = glm::dvec3(to_world[3]);
    if (json.find("range")) warnings.not_drawn("the range of point lights");
    return light;
  }
  // It shines along its node's -z.
  const glm::dvec3 towards_light(to_world[2]);
  const double length = glm::length(towards_light);
  if (!(length > 0) || !std::isfinite(length)) {
    warnings.not_drawn("lights of nodes whose scale is 0");
    return std::nullopt;
  }
  light.vector = towards_light / length;
  return light;
}

}  // namespace

std::optional<GltfCamera> read_camera(const GltfDocument& document, const GltfNodes& nodes,
                                      const std::optional<std::string>& wanted, std::vector<ModelPart>& parts,
                                      GltfWarnings& warnings) {
  const std::vector<int> camera_of_node = node_cameras(document, nodes.nodes.size());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < document.count("cameras"); ++i)
    names.push_back(warnings.read_name(document.element("cameras", i), ""));
  for (std::size_t i = 0; i < camera_of_node.size(); ++i)
    if (const int index = camera_of_node[i]; index >= 0 && names[static_cast<std::size_t>(index)].empty())
      names[static_cast<std::size_t>(index)] = nodes.nodes[i].name;
  const int chosen = wanted ? find_camera(names, *wanted, nodes, camera_of_node, document) : -1;

  int holder = -1;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < camera_of_node.size(); ++i) {
    if (camera_of_node[i] < 0) continue;
    if (chosen >= 0 ? camera_of_node[i] != chosen : !nodes.drawn[i]) continue;
    if (holder < 0 || (!nodes.drawn[static_cast<std::size_t>(holder)] && nodes.drawn[i])) holder = static_cast<int>(i);
    ++drawn;
  }
  if (chosen >= 0 && holder < 0)
    throw Error(ErrorKind::usage, document.path(),
                fmt::format("no node holds cameras[{}], so it stands nowhere", chosen));
  if (!wanted && drawn > 1)
    warnings.say(
        fmt::format("{}: several cameras, and the first is used; --camera, or name in a shot's camera, chooses "
                    "another: {}",
                    document.path(), numbered(names)));
  const int used = holder < 0 ? -1 : camera_of_node[static_cast<std::size_t>(holder)];
  for (std::size_t i = 0; i < names.size(); ++i)
    parts.push_back(
        {document.path(), ModelPart::Kind::camera, static_cast<int>(i), names[i], 0, static_cast<int>(i) == used});
  if (used < 0) return std::nullopt;
  const GltfValue json = document.element("cameras", static_cast<std::size_t>(used));
  GltfCamera result;
  result.camera.projection = read_projection(json);
  result.camera.node = holder;
  result.aspect = authored_aspect(json, warnings);
  return result;
}

std::vector<Light> read_lights(const GltfDocument& document, const GltfNodes& nodes, GltfWarnings& warnings) {
  std::vector<Light> result;
  const auto lights = light_array(document);
  if (!lights) return result;
  const std::vector<glm::dmat4> to_world = rest_to_world(nodes);
  const std::vector<bool> moving = moving_nodes(nodes);
  for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
    const auto extensions = document.element("nodes", i).find("extensions");
    const auto extension = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    if (!extension) continue;
    const int index = extension->get("light").index(lights->size(), "lights");
    if (!nodes.drawn[i]) continue;
    if (moving[i]) warnings.say("lights stay where their nodes are at rest");
    if (const auto light = read_light((*lights)[static_cast<std::size_t>(index)], to_world[i], warnings))
      result.push_back(*light);
  }
  return result;
}

}  // namespace morphcl
