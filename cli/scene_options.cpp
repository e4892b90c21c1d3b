#include "cli/scene_options.hpp"

#include "cli/console.hpp"
#include "cli/option_values.hpp"
#include "cli/stop_signals.hpp"
#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::cli {

Scene open_scene(const SceneOptions& options) {
  LoadOptions load;
  load.allow_outside = options.allow_outside;
  load.animation = options.animation;
  load.camera = options.camera;
  load.scene = options.scene;
  load.view = options.view;
  load.stop = &stop_requested();
  if (options.fps) load.fps = parse_fps(*options.fps);
  ImageSettings checked;  // so that a wrong option is reported before a large file is read
  if (options.size) {
    const ImageSize size = parse_size(*options.size);
    load.width = size.width;
    load.height = size.height;
  }
  if (options.channels) set_channels(*options.channels, checked);
  if (options.compression) set_compression(*options.compression, checked);
  if (options.depth_buffer) set_depth_buffer(*options.depth_buffer, checked);
  if (options.z_error) set_z_error(*options.z_error, checked);
  if (options.samples) set_samples(*options.samples, checked);

  Scene scene = load_scene(options.path, load);
  if (options.channels) set_channels(*options.channels, scene.image);
  if (options.compression) set_compression(*options.compression, scene.image);
  if (options.depth_buffer) set_depth_buffer(*options.depth_buffer, scene.image);
  if (options.z_error) set_z_error(*options.z_error, scene.image);
  if (options.samples) set_samples(*options.samples, scene.image);
  return scene;
}

void print_warnings(const Scene& scene) {
  for (const std::string& warning : scene.warnings) print_message("warning: " + printable(warning));
}

}  // namespace morphcl::cli
