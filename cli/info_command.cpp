#include "cli/info_command.hpp"

#include <filesystem>

#include "cli/exit_code.hpp"

namespace morphcl::cli {

int info_command(const InfoOptions& options) {
  if (std::filesystem::path(options.path).extension() == ".exr") {
    print_image_info(options.path, options.json);
  } else {
    SceneOptions scene;
    scene.path = options.path;
    scene.allow_outside = options.allow_outside;
    print_scene_info(open_scene(scene), options.json);
  }
  return exit_done;
}

}  // namespace morphcl::cli
