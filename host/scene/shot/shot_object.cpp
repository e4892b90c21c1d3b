#include "host/scene/shot/shot_object.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "host/scene/model/base_color.hpp"
#include "host/scene/shot/color_hint.hpp"
#include "host/scene/shot/nearest_name.hpp"
#include "host/scene/shot/object_motion.hpp"
#include "host/scene/shot/shot_elastic.hpp"

namespace morphcl {

namespace {

constexpr std::string_view morph_prefix = "morph.";

Shading read_shading(const ShotValue& shading) {
  const std::string& name = shading.text();
  if (name == "flat") return Shading::flat;
  if (name == "smooth") return Shading::smooth;
  if (name == "unlit") return Shading::unlit;
  if (name == "wireframe") return Shading::wireframe;
  if (name == "hidden_line")
    shading.fail("shading \"hidden_line\": not drawn by this version: flat, smooth, unlit and wireframe are");
  shading.fail(
      fmt::format("unknown shading \"{}\"{}", name, suggestion(name, {"flat", "smooth", "unlit", "wireframe"})));
}

glm::dvec4 read_base_color(const ShotValue& color) {
  refuse_color_text(color);
  if (!color.is_array() || (color.size() != 3 && color.size() != 4))
    color.fail("color must be three or four numbers: [red, green, blue] or [red, green, blue, alpha]");
  refuse_codes(color);
  glm::dvec4 value(0, 0, 0, 1);
  for (std::size_t c = 0; c < color.size(); ++c) {
    const double component = color[c].number();
    if (component < 0 || (c == 3 && component > 1))
      color[c].fail(fmt::format("color holds {}; {} is needed", component, c == 3 ? "0 to 1" : "0 or more"));
    value[static_cast<int>(c)] = component;
  }
  return value;
}

double read_line_width(const ShotValue& value) {
  const double width = value.number();
  if (!(width > 0 && width <= max_line_width))
    value.fail(fmt::format("line_width is {}; more than 0 and at most {} pixels is needed", width, max_line_width));
  return width;
}

void read_material(const ShotTable& table, Material& material) {
  if (const auto shading = table.find("shading")) material.shading = read_shading(*shading);
  if (const auto color = table.find("color")) {
    material.base_color = read_base_color(*color);
    material.alpha_mode = AlphaMode::blend;
  }
  if (const auto double_sided = table.find("double_sided")) material.double_sided = double_sided->boolean();
  if (const auto width = table.find("line_width")) material.line_width = read_line_width(*width);
}

// mesh = "none": nothing of its own is drawn, so that nothing may say how.
bool is_group(const ShotTable& table) {
  if (table.need("mesh").text() != "none") return false;
  if (!table.has("name")) table.value().fail("a group, mesh = \"none\", needs a name that others have as their parent");
  for (const TomlEntry& entry : table.entries())
    if (entry.key != "name" && entry.key != "mesh" && entry.key != "parent" && entry.key != "transform" &&
        entry.key != "track")
      table.need(entry.key).fail(fmt::format("a group, mesh = \"none\", draws nothing; it has no {}", entry.key));
  return true;
}

// Keys of a colour with alpha: by the first of them.
bool have_alpha(const ShotTable& track) {
  const ShotValue keys = track.need("keys");
  return keys.is_array() && keys.size() > 0 && keys[0].is_array() && keys[0].size() > 1 && keys[0][1].is_array() &&
         keys[0][1].size() == 4;
}

std::vector<std::string_view> object_targets() {
  std::vector<std::string_view> targets = ObjectMotion::node_targets();
  targets.insert(targets.end(), {"color", "morph.NAME"});
  return targets;
}

}  // namespace

std::string ObjectReader::read_name(const ShotTable& table) {
  const auto name = table.find("name");
  if (!name) return table.need("mesh").text();
  if (name->text().empty()) name->fail("name is empty");
  if (!names_.insert(name->text()).second) name->fail(fmt::format("the name \"{}\" is used twice", name->text()));
  return name->text();
}

void ObjectReader::read(const ShotValue& object) {
  const ShotTable table =
      object.table({"name", "mesh", "animation", "scene", "targets", "morph_to", "segments", "profile", "points",
                    "shading", "color", "double_sided", "line_width", "parent", "transform", "elastic", "track"});
  const std::string name = read_name(table);
  const bool group = is_group(table);

  const int root = static_cast<int>(scene_.timeline.nodes.size());
  Node node;
  node.name = name;
  scene_.timeline.nodes.push_back(std::move(node));
  if (table.has("name")) parents_.add_named(name, root);
  if (const auto parent = table.find("parent")) parents_.hang_node(*parent, root);

  const std::size_t first_object = scene_.objects.size();
  if (!group) add_model(table, library_.model(table), root, name);
  read_tracks(table, root, first_object);
  if (const auto elastic = table.find("elastic")) make_elastic(*elastic, first_object);
  const auto color = table.find("color");
  const bool fades = first_object < scene_.objects.size() && moves_alpha(scene_.objects[first_object].material);
  if (color && color->size() == 4 && (*color)[3].number() == 0 && !fades) scene_.objects.resize(first_object);
}

void ObjectReader::add_model(const ShotTable& table, const ImportedModel& model, int root, const std::string& name) {
  const int first_node = root + 1;
  for (Node node : model.nodes) {
    node.parent = node.parent < 0 ? root : node.parent + first_node;
    scene_.timeline.nodes.push_back(std::move(node));
  }
  for (Object part : model.objects) {
    part.name = model.objects.size() == 1 ? name : fmt::format("{}/{}", name, part.name);
    part.node += first_node;
    read_material(table, part.material);
    scene_.objects.push_back(std::move(part));
  }
}

void ObjectReader::read_tracks(const ShotTable& object, int root, std::size_t first_object) {
  Node& node = scene_.timeline.nodes[static_cast<std::size_t>(root)];
  ObjectMotion motion(object, tracks_);
  std::unordered_set<std::string> driven;
  object.for_each("track", [&](const ShotValue& value) {
    const ShotTable track = TrackReader::table(value);
    const ShotValue target = TrackReader::target(track);
    const std::string& name = target.text();
    if (!driven.insert(name).second) target.fail(fmt::format("{} is driven twice", name));
    if (name.starts_with(morph_prefix))
      drive_morph(track, name.substr(morph_prefix.size()), first_object);
    else if (!motion.read_track(target, track, tracks_, node) && !read_color_track(target, track, first_object))
      target.fail(fmt::format("an object has no value \"{}\" to move{}", name, suggestion(name, object_targets())));
  });
  motion.finish(node);
}

bool ObjectReader::read_color_track(const ShotValue& target, const ShotTable& table, std::size_t first_object) {
  if (target.text() != "color") return false;
  if (first_object == scene_.objects.size()) target.fail("a group, mesh = \"none\", draws nothing; it has no color");
  const Track track = tracks_.read(table, have_alpha(table) ? KeyValue::color_and_alpha : KeyValue::color);
  for (std::size_t i = first_object; i < scene_.objects.size(); ++i) {
    scene_.objects[i].material.base_color_track = track;
    if (track.width() == 4) scene_.objects[i].material.alpha_mode = AlphaMode::blend;
  }
  return true;
}

void ObjectReader::make_elastic(const ShotValue& value, std::size_t first_object) {
  const Elastic elastic = read_elastic(value);
  bool moves = false;
  for (std::size_t i = first_object; i < scene_.objects.size(); ++i)
    for (const MorphTarget& target : library_.mesh(scene_.objects[i].mesh).targets)
      if (!target.positions.empty()) {
        moves = true;
        scene_.objects[i].morph.elastic = elastic;
      }
  if (!moves) value.fail("an elastic object follows its morph; the mesh has no morph targets that move vertices");
}

void ObjectReader::drive_morph(const ShotTable& table, const std::string& name, std::size_t first_object) {
  const ShotValue target = TrackReader::target(table);
  const Track track = tracks_.read(table, KeyValue::number);
  bool found = false;
  std::vector<std::string_view> known;
  for (std::size_t i = first_object; i < scene_.objects.size(); ++i) {
    const std::vector<MorphTarget>& targets = library_.mesh(scene_.objects[i].mesh).targets;
    for (std::size_t t = 0; t < targets.size(); ++t) {
      known.push_back(targets[t].name);
      if (targets[t].name != name) continue;
      scene_.objects[i].morph.tracks.push_back({static_cast<int>(t), track});
      found = true;
    }
  }
  if (!found)
    target.fail(known.empty() ? fmt::format("morph.{}: the mesh has no morph targets", name)
                              : fmt::format("the mesh has no morph target \"{}\"{}", name, suggestion(name, known)));
}

}  // namespace morphcl
