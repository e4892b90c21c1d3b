#include "host/scene/shot/shot_file.hpp"

#include <utility>

#include "host/scene/model/content_hash.hpp"
#include "host/scene/model/fitted_camera.hpp"
#include "host/scene/model/input_file.hpp"
#include "host/scene/shot/color_hint.hpp"
#include "host/scene/shot/mesh_library.hpp"
#include "host/scene/shot/parent_links.hpp"
#include "host/scene/shot/shot_camera.hpp"
#include "host/scene/shot/shot_light.hpp"
#include "host/scene/shot/shot_object.hpp"
#include "host/scene/shot/shot_settings.hpp"
#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "host/scene/shot/toml_document.hpp"
#include "host/scene/shot/vanishing_marks.hpp"

namespace morphcl {

namespace {

void read_image_and_time(const ShotTable& shot, const LoadOptions& options, Scene& scene) {
  scene.image = read_image_settings(shot.find("image"));
  scene.accuracy_pixels = read_accuracy(shot.find("accuracy"));
  scene.image.width = options.width.value_or(scene.image.width);
  scene.image.height = options.height.value_or(scene.image.height);
  FrameSettings frames = read_frame_settings(shot.find("frames"));
  scene.timeline.time = options.fps.value_or(frames.time);
  scene.frames = std::move(frames.ranges);
}

}  // namespace

Scene read_shot(const std::string& path, const LoadOptions& options) {
  Scene scene = read_shot_text(read_input_file(path, max_toml_bytes), path, options);
  scene.inputs.push_back(path);
  return scene;
}

Scene read_shot_text(std::string_view text, const std::string& path, const LoadOptions& options) {
  const TomlValue document = parse_toml(text, path);
  const ShotTable shot = ShotValue(path, document, "a shot")
                             .table({"image", "accuracy", "frames", "ambient", "camera", "light", "object"});
  Scene scene;
  read_image_and_time(shot, options, scene);
  TrackReader tracks(scene.timeline.time);
  if (const auto ambient = shot.find("ambient")) {
    scene.timeline.ambient = ambient->color();
    refuse_codes(*ambient);
  }
  ParentLinks parents;
  const auto camera = shot.find("camera");
  ShotCamera shot_camera;
  ImportLimits limits;
  limits.allow_outside = options.allow_outside;
  limits.stop = options.stop;
  MeshLibrary library(path, scene.timeline.time, limits);
  shot_camera =
      camera ? read_camera(*camera, options.view, tracks, library, parents, scene) : fitted_shot_camera(options.view);
  scene.timeline.camera = std::move(shot_camera.camera);
  shot.for_each("light", [&](const ShotValue& light) {
    const std::size_t index = scene.timeline.lights.size();
    scene.timeline.lights.push_back(read_light(light, index, tracks, parents));
  });

  ObjectReader objects(library, tracks, parents, scene);
  shot.for_each("object", [&](const ShotValue& object) { objects.read(object); });
  const auto object_list = shot.find("object");
  if (!object_list || (object_list->is_array() && object_list->size() == 0))
    shot.value().fail("nothing to draw; a shot needs at least one [[object]] with a mesh");
  parents.resolve(scene.timeline);
  scene.meshes = library.take_meshes();
  scene.parts = library.parts();
  scene.warnings.insert(scene.warnings.end(), library.warnings().begin(), library.warnings().end());
  scene.inputs = library.inputs();
  complete_scene(scene,
                 {.camera = !shot_camera.fit,
                  .lights = shot.has("light"),
                  .frames = !scene.frames.empty(),
                  .ambient = shot.has("ambient")},
                 shot_camera.fit.value_or(CameraFit{}));
  if (shot_camera.marks_vanishing_points) add_vanishing_marks(scene);

  ContentHash hash;
  hash.add(text);
  library.add_to(hash);
  scene.content_hash = hash.hex();
  return scene;
}

}  // namespace morphcl
