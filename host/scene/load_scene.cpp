#include "morphcl/scene.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "host/scene/gltf/gltf_import.hpp"
#include "host/scene/model/fitted_camera.hpp"
#include "host/scene/obj/obj_import.hpp"
#include "host/scene/shot/shot_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

std::string lower_case_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

Scene scene_of(ImportedModel model, const LoadOptions& options) {
  Scene scene;
  scene.meshes = std::move(model.meshes);
  scene.objects = std::move(model.objects);
  scene.warnings = std::move(model.warnings);
  scene.content_hash = std::move(model.content_hash);
  scene.timeline.time = options.fps.value_or(TimeBase{});
  scene.timeline.nodes = std::move(model.nodes);
  scene.timeline.lights = std::move(model.lights);
  scene.image.width = options.width.value_or(scene.image.width);
  scene.image.height = options.height.value_or(scene.image.height);
  const bool has_camera = model.camera.has_value();
  if (has_camera) scene.timeline.camera = *model.camera;
  complete_scene(scene, {.camera = has_camera, .lights = !scene.timeline.lights.empty(), .frames = false});
  return scene;
}

// They are right where a scene of nothing else is valid.
void check_options(const LoadOptions& options) {
  Scene scene;
  scene.timeline.time = options.fps.value_or(scene.timeline.time);
  scene.image.width = options.width.value_or(scene.image.width);
  scene.image.height = options.height.value_or(scene.image.height);
  try {
    validate(scene);
  } catch (const Error& error) {
    throw Error(ErrorKind::usage, "", error.message());
  }
}

Scene load(const std::string& path, const LoadOptions& options) {
  const std::string extension = lower_case_extension(path);
  const TimeBase time = options.fps.value_or(TimeBase{});
  ImportLimits limits;
  limits.allow_outside = options.allow_outside;
  if (extension == ".toml") return read_shot(path, options);
  if (extension == ".gltf" || extension == ".glb") return scene_of(import_gltf(path, time, limits), options);
  if (extension == ".obj") return scene_of(import_obj(path, limits), options);
  throw Error(ErrorKind::usage, path, "not a scene; a .toml shot or a .gltf, .glb or .obj model is needed");
}

}  // namespace

Scene load_scene(const std::string& path, const LoadOptions& options) {
  try {
    check_options(options);
    Scene scene = load(path, options);
    scene.name = std::filesystem::path(path).stem().string();
    validate(scene);
    return scene;
  } catch (const Error& error) {
    throw error.at(path);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::bad_input, path, "the scene needs more memory than there is");
  }
}

}  // namespace morphcl
