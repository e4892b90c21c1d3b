#include "host/scene/shot/mesh_library.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "host/lower_case.hpp"
#include "host/scene/gltf/gltf_import.hpp"
#include "host/scene/model/input_file.hpp"
#include "host/scene/obj/obj_import.hpp"
#include "host/scene/shot/formula_mesh.hpp"
#include "host/scene/shot/morph_shapes.hpp"
#include "host/scene/shot/nearest_name.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

bool is_model_file(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".gltf" || extension == ".glb" || extension == ".obj";
}

int segment_count(const ShotValue& value) {
  const std::int64_t count = value.integer();
  if (count < 1 || count > max_solid_vertices) value.fail(fmt::format("segments holds {}; 1 or more is needed", count));
  return static_cast<int>(count);
}

std::optional<Segments> read_segments(const ShotTable& object) {
  const auto segments = object.find("segments");
  if (!segments) return std::nullopt;
  if (!segments->is_array() || segments->size() != 2) segments->fail("segments must be two integers: [u, v]");
  return Segments{.u = segment_count((*segments)[0]), .v = segment_count((*segments)[1])};
}

// A name, or an index as an integer.
std::optional<std::string> read_choice(const ShotTable& table, const char* key) {
  const auto value = table.find(key);
  if (!value) return std::nullopt;
  return value->is_text() ? value->text() : std::to_string(value->integer());
}

// A choice that the model does not have is at fault here, not in the model.
ImportedModel import_chosen(const ShotTable& table, const std::function<ImportedModel()>& import) {
  try {
    return import();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::usage) throw;
    table.value().fail(error.message());
  }
}

// What a shape of morph_to is when it is written as a table.
ShotTable shape_table(const ShotValue& shape) { return shape.table({"mesh", "segments", "name", "profile", "points"}); }

// One text for all that decides which mesh an object gets; '\n' separates, as no file name in a shot may hold it.
std::string request(const ShotTable& object) {
  std::string text = object.need("mesh").text() + formula_text(object);
  if (const auto segments = read_segments(object)) text += fmt::format("\nsegments {} {}", segments->u, segments->v);
  for (const char* key : {"animation", "scene"})
    if (const auto wanted = read_choice(object, key)) text += fmt::format("\n{} {}", key, *wanted);
  if (const auto targets = object.find("targets"))
    for (std::size_t i = 0; i < targets->size(); ++i) text += "\ntarget " + (*targets)[i].text();
  if (const auto shapes = object.find("morph_to"))
    for (std::size_t i = 0; i < shapes->size(); ++i) {
      const ShotValue shape = (*shapes)[i];
      if (shape.is_text()) {
        text += "\nmorph_to " + shape.text();
        continue;
      }
      const ShotTable table = shape_table(shape);
      const auto name = table.find("name");
      text += fmt::format("\nmorph_to {} as {}", request(table), name ? name->text() : "");
    }
  return text;
}

// What a target is called: as the table says, else as the solid, or the file without its extension.
std::string shape_name(const ShotValue& shape) {
  if (!shape.is_text()) {
    const ShotTable table = shape_table(shape);
    if (const auto name = table.find("name")) return name->text();
    return shape_name(table.need("mesh"));
  }
  return is_model_file(shape.text()) ? std::filesystem::path(shape.text()).stem().string() : shape.text();
}

// One mesh, one object and one node.
ImportedModel model_of(Mesh mesh, const std::string& name) {
  ImportedModel model;
  model.meshes.push_back(std::move(mesh));
  Object part;
  part.name = name;
  part.morph.weights.assign(model.meshes.back().targets.size(), 0.0);
  model.objects.push_back(part);
  model.nodes.emplace_back();
  return model;
}

// A path of Windows, as it is, or with a part of it read as an escape.
std::string_view backslash_hint(std::string_view path) {
  if (path.find('\\') != std::string_view::npos) return "; folders are separated by /";
  if (path.find_first_of("\t\b\f\n\r") != std::string_view::npos)
    return "; in double quotes a backslash begins an escape: write / in paths";
  return "";
}

}  // namespace

MeshLibrary::MeshLibrary(std::string shot, const TimeBase& time, const ImportLimits& limits, long long max_vertices)
    : shot_(std::move(shot)), time_(time), limits_(limits), max_vertices_(max_vertices), vertices_left_(max_vertices) {}

const ImportedModel& MeshLibrary::model(const ShotTable& object) {
  const std::string key = request(object);
  if (const auto known = models_.find(key); known != models_.end()) return known->second;

  ImportedModel model = make(object);
  if (object.has("morph_to")) add_shapes(object, model);
  const int first_mesh = static_cast<int>(meshes_.size());
  for (Object& part : model.objects) part.mesh += first_mesh;
  for (Mesh& mesh : model.meshes) meshes_.push_back(std::move(mesh));
  model.meshes.clear();
  parts_.insert(parts_.end(), model.parts.begin(), model.parts.end());
  return models_.emplace(key, std::move(model)).first->second;
}

ImportedModel MeshLibrary::make(const ShotTable& object) {
  const std::string& name = object.need("mesh").text();
  refuse_other_formulas(object);
  const bool built_in = find_solid(name) != nullptr || is_formula_mesh(name);
  ImportedModel model = built_in ? make_built_in(object) : import_file(object);
  take_notes(model, name);
  return model;
}

void MeshLibrary::take_notes(const ImportedModel& model, const std::string& name) {
  inputs_.insert(inputs_.end(), model.inputs.begin(), model.inputs.end());
  warnings_.insert(warnings_.end(), model.warnings.begin(), model.warnings.end());
  if (model.camera || !model.lights.empty())
    warnings_.push_back(fmt::format("{}: its camera and lights are not used in a shot", name));
  if (!model.content_hash.empty()) hashes_.push_back(model.content_hash);
}

ImportedModel MeshLibrary::make_shape(const ShotTable& object, const ShotValue& shape) {
  if (!shape.is_text()) return make(shape_table(shape));
  const SolidInfo* const solid = find_solid(shape.text());
  if (solid) {
    const bool cut = solid->minimum.u > 0;
    return make_solid_model(shape, cut ? read_segments(object) : std::nullopt, shape);
  }
  if (!is_model_file(shape.text()))
    shape.fail(
        fmt::format("morph_to \"{}\": a built-in solid, a .gltf, .glb or .obj file, or a table with the key mesh "
                    "is needed",
                    shape.text()));
  const std::string path = existing_file(shape);
  ImportedModel model = lower_case_extension(path) == ".obj" ? import_obj(path, limits_)
                                                             : import_gltf(path, time_, limits_, ModelChoice{});
  take_notes(model, shape.text());
  return model;
}

void MeshLibrary::add_shapes(const ShotTable& object, ImportedModel& model) {
  const ShotValue shapes = object.need("morph_to");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const ShotValue shape = shapes[i];
    const ImportedModel other = make_shape(object, shape);
    if (other.meshes.size() != model.meshes.size())
      shape.fail(fmt::format("it has {} meshes and the object {}; a morph needs the same topology", other.meshes.size(),
                             model.meshes.size()));
    for (std::size_t m = 0; m < model.meshes.size(); ++m)
      add_shape(other.meshes[m], shape_name(shape), shape, model.meshes[m]);
    for (Object& part : model.objects) part.morph.weights.push_back(0);
  }
}

void MeshLibrary::add_to(ContentHash& hash) const {
  for (const std::string& piece : hashes_) hash.add(piece);
}

ImportedModel MeshLibrary::make_built_in(const ShotTable& object) {
  if (const auto targets = object.find("targets"))
    targets->fail("targets belong to an .obj file, not to a built-in solid");
  for (const char* key : {"animation", "scene"})
    if (const auto value = object.find(key))
      value->fail(fmt::format("{} belongs to a glTF file, not to a built-in solid", key));
  const ShotValue name = object.need("mesh");
  if (is_formula_mesh(name.text())) {
    ImportedModel model = model_of(read_formula_mesh(object), name.text());
    if (name.text() == "curve") model.objects.back().material.shading = Shading::wireframe;
    charge(static_cast<long long>(model.meshes.back().positions.size()), name);
    return model;
  }
  const auto segments = read_segments(object);
  return make_solid_model(name, segments, segments ? object.need("segments") : name);
}

void MeshLibrary::charge(long long vertices, const ShotValue& place) {
  vertices_left_ -= vertices;
  if (vertices_left_ < 0)
    place.fail(fmt::format("the built-in solids have more than {} vertices together", max_vertices_));
}

ImportedModel MeshLibrary::make_solid_model(const ShotValue& name, std::optional<Segments> segments,
                                            const ShotValue& place) {
  charge(placed_at(place, [&] { return solid_vertices(name.text(), segments); }), place);
  return model_of(make_solid(name.text(), segments), name.text());
}

ImportedModel MeshLibrary::import_file(const ShotTable& object) {
  const ShotValue name = object.need("mesh");
  if (!is_model_file(name.text())) {
    std::vector<std::string_view> known;
    for (const SolidInfo& solid : solids()) known.push_back(solid.name);
    known.insert(known.end(), {"revolution", "curve", "none"});
    name.fail(fmt::format("mesh \"{}\" is neither a built-in solid nor a .gltf, .glb or .obj file{}", name.text(),
                          suggestion(name.text(), known)));
  }
  if (const auto segments = object.find("segments"))
    segments->fail("segments belong to a built-in solid, not to a file");
  const std::string path = existing_file(name);
  const auto targets = object.find("targets");
  const bool obj = lower_case_extension(path) == ".obj";
  if (targets && !obj) targets->fail("targets belong to an .obj file; a glTF file has its own");
  const ModelChoice choice{read_choice(object, "animation"), {}, read_choice(object, "scene")};
  if (!obj) return import_chosen(object, [&] { return import_gltf(path, time_, limits_, choice); });
  for (const char* key : {"animation", "scene"})
    if (const auto value = object.find(key))
      value->fail(fmt::format("{} belongs to a glTF file; an .obj has none", key));
  if (!targets) return import_obj(path, limits_);
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < targets->size(); ++i) {
    const ShotValue target = (*targets)[i];
    if (lower_case_extension(target.text()) != ".obj")
      target.fail(fmt::format("target \"{}\" is not an .obj file", target.text()));
    paths.push_back(existing_file(target));
  }
  return import_obj_targets(path, paths, limits_);
}

ImportedModel MeshLibrary::camera_model(const ShotTable& camera) {
  const ShotValue file = camera.need("model");
  const std::string extension = lower_case_extension(file.text());
  if (extension != ".gltf" && extension != ".glb")
    file.fail(fmt::format("model \"{}\" is not a .gltf or .glb file, which may hold cameras", file.text()));
  const std::string path = existing_file(file);
  const ModelChoice choice{read_choice(camera, "animation"), read_choice(camera, "name"), {}};
  ImportedModel model = import_chosen(camera, [&] { return import_gltf_camera(path, time_, limits_, choice); });
  inputs_.insert(inputs_.end(), model.inputs.begin(), model.inputs.end());
  hashes_.push_back(model.content_hash);
  return model;
}

std::string MeshLibrary::existing_file(const ShotValue& reference) const {
  const std::string path = confined_path(shot_, reference.text(), limits_.allow_outside, reference.place());
  std::error_code problem;
  if (!std::filesystem::exists(path, problem))
    throw Error(ErrorKind::cannot_read, reference.place(),
                fmt::format("there is no file \"{}\"{}", reference.text(), backslash_hint(reference.text())));
  return path;
}

}  // namespace morphcl
