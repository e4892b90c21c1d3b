#include <fmt/core.h>

#include <algorithm>

#include "anim/timeline_at.hpp"
#include "cli/camera_info.hpp"
#include "cli/console.hpp"
#include "cli/info_command.hpp"
#include "cli/json_object.hpp"
#include "cli/node_path.hpp"
#include "cli/object_info.hpp"
#include "cli/table.hpp"
#include "host/scene/model/material_list.hpp"
#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::cli {

namespace {
const char* shading_name(const Scene& scene, const Object& object) {
  switch (object.material.shading) {
    case Shading::flat:
      return "flat";
    case Shading::smooth:
      return scene.meshes[object.mesh].normals.empty() ? "flat" : "smooth";
    case Shading::unlit:
      return "unlit";
    case Shading::wireframe:
      return "wireframe";
  }
  return "flat";
}

std::string range_text(const std::vector<FrameRange>& ranges) {
  std::string text;
  for (const FrameRange& range : ranges) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", range.first);
    if (range.last != range.first) text += fmt::format("-{}", range.last);
    if (range.step != 1) text += fmt::format("x{}", range.step);
  }
  return text;
}

std::string fps_text(const TimeBase& time) {
  return time.fps_denominator == 1 ? std::to_string(time.fps_numerator)
                                   : fmt::format("{}/{}", time.fps_numerator, time.fps_denominator);
}

std::string target_names(const Mesh& mesh) {
  std::string names;
  for (const MorphTarget& target : mesh.targets) names += (names.empty() ? "" : ", ") + target.name;
  return names;
}

const char* kind_name(ModelPart::Kind kind) {
  switch (kind) {
    case ModelPart::Kind::animation:
      return "animation";
    case ModelPart::Kind::camera:
      return "camera";
    case ModelPart::Kind::scene:
      return "scene";
  }
  return "scene";
}

// What can be chosen, so a single scene or camera need not be told.
bool is_choice(const Scene& scene, const ModelPart& part) {
  const auto alike = [&](const ModelPart& other) { return other.kind == part.kind && other.model == part.model; };
  return part.kind == ModelPart::Kind::animation || std::count_if(scene.parts.begin(), scene.parts.end(), alike) > 1;
}

std::string part_text(const ModelPart& part) {
  std::string text = fmt::format("{} '{}'", part.index, part.name);
  if (part.kind == ModelPart::Kind::animation) text += fmt::format(", {:.6g} s", part.seconds);
  return text + (part.used ? "" : ", not used");
}

std::string channel_list(ChannelSet channels, std::string_view separator) {
  std::string text;
  for (const Channel channel : channels) text += fmt::format("{}{}", text.empty() ? "" : separator, name_of(channel));
  return text;
}

std::string image_text(const ImageSettings& image) {
  std::string text =
      fmt::format("{}x{}, {}, {}", image.width, image.height, channel_list(image.channels, " "), image.compression);
  if (image.channel_names != ChannelNames::plain)
    text += fmt::format(", {} channel names", name_of(image.channel_names));
  if (image.z_error != 0) text += fmt::format(", Z within {} of itself", image.z_error);
  if (image.p_error != 0) text += fmt::format(", P within {} of itself", image.p_error);
  if (image.n_error != 0) text += fmt::format(", N within {}", image.n_error);
  return text;
}

// Standing at the first frame.
NodeSampler first_nodes(const Scene& scene) {
  NodeSampler nodes(scene.timeline.nodes);
  nodes.go_to(tick_of(scene.timeline.time, frame_numbers(scene.frames).front()));
  return nodes;
}

std::string camera_parent(const Scene& scene) {
  return node_path(scene.timeline.nodes, node_of(scene.timeline.camera));
}

std::string below(const std::string& path) { return path.empty() ? "" : ", below " + path; }

void print_json(const Scene& scene) {
  const CameraInfo camera = describe_camera(scene);
  print_result(line_of(json_object("scene", {{"name", scene.name},
                                             {"width", scene.image.width},
                                             {"height", scene.image.height},
                                             {"channels", channel_list(scene.image.channels, ",")},
                                             {"channel_names", std::string(name_of(scene.image.channel_names))},
                                             {"compression", scene.image.compression},
                                             {"z_error", scene.image.z_error},
                                             {"p_error", scene.image.p_error},
                                             {"n_error", scene.image.n_error},
                                             {"frames", range_text(scene.frames)},
                                             {"fps", fps_text(scene.timeline.time)},
                                             {"objects", scene.objects.size()},
                                             {"nodes", scene.timeline.nodes.size()},
                                             {"lights", scene.timeline.lights.size()},
                                             {"projection", camera.projection},
                                             {"window", camera.window},
                                             {"vanishing_points", camera.vanishing_points},
                                             {"camera_parent", camera_parent(scene)},
                                             {"content_hash", scene.content_hash}})));
  for (const Mesh& mesh : scene.meshes)
    print_result(line_of(json_object("mesh", {{"name", mesh.name},
                                              {"vertices", mesh.positions.size()},
                                              {"triangles", mesh.triangles.size()},
                                              {"normals", !mesh.normals.empty()},
                                              {"colors", !mesh.colors.empty()},
                                              {"uvs", !mesh.uvs.empty()},
                                              {"targets", mesh.targets.size()},
                                              {"target_names", target_names(mesh)}})));
  for (const ModelPart& part : scene.parts)
    print_result(line_of(json_object(kind_name(part.kind), {{"model", part.model},
                                                            {"index", part.index},
                                                            {"name", part.name},
                                                            {"seconds", part.seconds},
                                                            {"used", part.used}})));
  const MaterialList materials = list_materials(scene);
  for (std::size_t i = 0; i < materials.names.size(); ++i)
    print_result(line_of(json_object("material", {{"id", i + 1}, {"name", materials.names[i]}})));
  NodeSampler nodes = first_nodes(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    print_result(line_of(json_object("object", {{"id", i + 1},
                                                {"name", object.name},
                                                {"mesh", scene.meshes[object.mesh].name},
                                                {"material", materials.names[materials.of_object[i]]},
                                                {"shading", shading_name(scene, object)},
                                                {"parent", node_path(scene.timeline.nodes, object.node, object.name)},
                                                {"placement", describe_placement(object, nodes)}})));
  }
  for (const std::string& warning : scene.warnings) print_result(line_of(json_object("warning", {{"text", warning}})));
}

void print_table(const Scene& scene) {
  std::vector<std::vector<std::string>> rows = {
      {"name", printable(scene.name)},
      {"image", image_text(scene.image)},
      {"frames", fmt::format("{} at {} per second", range_text(scene.frames), fps_text(scene.timeline.time))},
      {"nodes", std::to_string(scene.timeline.nodes.size())},
      {"lights", std::to_string(scene.timeline.lights.size())}};
  const CameraInfo camera = describe_camera(scene);
  rows.push_back({"camera", printable(camera.projection + below(camera_parent(scene)))});
  rows.push_back({"window", camera.window});
  rows.push_back({"vanishing points", camera.vanishing_points});
  for (const ModelPart& part : scene.parts)
    if (is_choice(scene, part)) rows.push_back({kind_name(part.kind), printable(part_text(part))});
  for (const Mesh& mesh : scene.meshes) {
    std::string text =
        fmt::format("{}: {} vertices, {} triangles", mesh.name, mesh.positions.size(), mesh.triangles.size());
    if (!mesh.targets.empty()) text += fmt::format(", {} morph targets: {}", mesh.targets.size(), target_names(mesh));
    rows.push_back({"mesh", printable(text)});
  }
  // Where no material has a name of its own there is one an object, of its name.
  const auto is_named = [](const Object& object) { return !object.material.name.empty(); };
  if (std::any_of(scene.objects.begin(), scene.objects.end(), is_named)) {
    const std::vector<std::string> materials = material_names(scene);
    for (std::size_t i = 0; i < materials.size(); ++i)
      rows.push_back({"material", printable(fmt::format("{}: {}", i + 1, materials[i]))});
  }
  NodeSampler nodes = first_nodes(scene);
  for (const Object& object : scene.objects)
    rows.push_back({"object", printable(fmt::format("{}: {}, {}{}, {}", object.name, scene.meshes[object.mesh].name,
                                                    shading_name(scene, object),
                                                    below(node_path(scene.timeline.nodes, object.node, object.name)),
                                                    describe_placement(object, nodes)))});
  for (const std::string& warning : scene.warnings) rows.push_back({"warning", printable(warning)});
  for (const std::string& line : aligned(rows)) print_result(line);
}
}  // namespace

void print_scene_info(const Scene& scene, bool json) {
  if (json)
    print_json(scene);
  else
    print_table(scene);
}

}  // namespace morphcl::cli
