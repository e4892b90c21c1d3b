#include "cli/scene_options.hpp"

#include "cli/console.hpp"
#include "cli/option_values.hpp"
#include "cli/stop_signals.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::cli {

namespace {

void set_image(const SceneOptions& options, ImageSettings& image) {
  if (options.channels) set_channels(*options.channels, image);
  if (options.channel_names) set_channel_names(*options.channel_names, image);
  if (options.compression) set_compression(*options.compression, image);
  if (options.depth_buffer) set_depth_buffer(*options.depth_buffer, image);
  if (options.z_error) set_z_error(*options.z_error, image);
  if (options.p_error) set_p_error(*options.p_error, image);
  if (options.n_error) set_n_error(*options.n_error, image);
  if (options.samples) set_samples(*options.samples, image);
  if (options.visibility) set_visibility(*options.visibility, image);
}

// What each may be alone and both cannot be together; the shot has said what it can of its own.
void check_compression_of_channels(const SceneOptions& options, const ImageSettings& image) {
  try {
    if (options.compression || options.channels) check_compression(image.compression, image.channels);
  } catch (const Error& error) {
    throw error.at(options.compression ? "--compression" : "--channels");
  }
}

// The shot has said what it can of its own.
void check_visibility_of_samples(const SceneOptions& options, const ImageSettings& image) {
  try {
    if (options.visibility || options.samples) check_visibility(image);
  } catch (const Error& error) {
    throw error.at(options.visibility ? "--visibility" : "--samples");
  }
}

}  // namespace

Scene open_scene(const SceneOptions& options) {
  LoadOptions load;
  load.allow_outside = options.allow_outside;
  load.animation = options.animation;
  load.camera = options.camera;
  load.scene = options.scene;
  load.view = options.view;
  load.stop = &stop_requested();
  if (options.fps) load.fps = parse_fps(*options.fps);
  // So that a wrong option is reported before a large file is read; which channels it has is not known yet.
  ImageSettings checked;
  checked.channels = every_channel;
  if (options.size) {
    const ImageSize size = parse_size(*options.size);
    load.width = size.width;
    load.height = size.height;
  }
  set_image(options, checked);

  Scene scene = load_scene(options.path, load);
  set_image(options, scene.image);
  check_compression_of_channels(options, scene.image);
  check_visibility_of_samples(options, scene.image);
  return scene;
}

void print_warnings(const Scene& scene) {
  for (const std::string& warning : scene.warnings) print_message("warning: " + printable(warning));
}

}  // namespace morphcl::cli
