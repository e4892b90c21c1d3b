#include "morphcl/scene.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "host/lower_case.hpp"
#include "host/scene/gltf/gltf_import.hpp"
#include "host/scene/model/authored_camera.hpp"
#include "host/scene/model/fitted_camera.hpp"
#include "host/scene/model/named_view.hpp"
#include "host/scene/model/scene_warnings.hpp"
#include "host/scene/obj/obj_import.hpp"
#include "host/scene/shot/shot_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

Scene scene_of(ImportedModel model, const LoadOptions& options) {
  Scene scene;
  scene.meshes = std::move(model.meshes);
  scene.objects = std::move(model.objects);
  scene.parts = std::move(model.parts);
  scene.warnings = std::move(model.warnings);
  scene.content_hash = std::move(model.content_hash);
  scene.inputs = std::move(model.inputs);
  scene.timeline.time = options.fps.value_or(TimeBase{});
  scene.timeline.nodes = std::move(model.nodes);
  scene.timeline.lights = std::move(model.lights);
  scene.image.width = options.width.value_or(scene.image.width);
  scene.image.height = options.height.value_or(scene.image.height);
  const bool has_camera = model.camera.has_value() && !options.view;
  if (has_camera) {
    scene.timeline.camera = *model.camera;
    keep_authored_view(scene.timeline.camera, model.camera_aspect,
                       static_cast<double>(scene.image.width) / scene.image.height);
  }
  CameraFit fit;
  if (options.view) fit.view = needed_view(*options.view);
  complete_scene(scene, {.camera = has_camera, .lights = !scene.timeline.lights.empty(), .frames = false}, fit);
  return scene;
}

// They are right where a scene of nothing else is valid.
void check_options(const LoadOptions& options) {
  Scene scene;
  scene.timeline.time = options.fps.value_or(scene.timeline.time);
  scene.image.width = options.width.value_or(scene.image.width);
  scene.image.height = options.height.value_or(scene.image.height);
  if (options.view) needed_view(*options.view);
  if (options.view && options.camera)
    throw Error(ErrorKind::usage, "", "--camera takes a model's own camera and --view fits one; give one of the two");
  try {
    validate(scene);
  } catch (const Error& error) {
    throw Error(ErrorKind::usage, "", error.message());
  }
}

void refuse_choice(const LoadOptions& options, const std::string& path, std::string_view why) {
  const char* given = options.animation ? "animation" : options.camera ? "camera" : options.scene ? "scene" : nullptr;
  if (given) throw Error(ErrorKind::usage, path, fmt::format("--{} chooses from a glTF model; {}", given, why));
}

Scene load(const std::string& path, const LoadOptions& options) {
  const std::string extension = lower_case_extension(path);
  const TimeBase time = options.fps.value_or(TimeBase{});
  ImportLimits limits;
  limits.allow_outside = options.allow_outside;
  limits.stop = options.stop;
  const ModelChoice choice{options.animation, options.camera, options.scene};
  if (extension == ".gltf" || extension == ".glb") return scene_of(import_gltf(path, time, limits, choice), options);
  refuse_choice(options, path,
                extension == ".toml" ? "a shot says so itself: animation and scene in an [[object]], "
                                       "model and name in [camera]"
                                     : "an .obj file holds none");
  if (extension == ".toml") return read_shot(path, options);
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
    warn_of_oddities(scene);
    return scene;
  } catch (const Error& error) {
    throw error.at(path);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::bad_input, path, "the scene needs more memory than there is");
  }
}

}  // namespace morphcl
