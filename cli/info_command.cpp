#include "cli/info_command.hpp"

#include <filesystem>

#include "cli/exit_code.hpp"

namespace morphcl::cli {

int info_command(const InfoOptions& options) {
  if (std::filesystem::path(options.scene.path).extension() == ".exr")
    print_image_info(options.scene.path, options.json);
  else
    print_scene_info(open_scene(options.scene), options.json);
  return exit_done;
}

}  // namespace morphcl::cli
