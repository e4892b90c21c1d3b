#include "cli/info_command.hpp"

#include <string>

#include "cli/exit_code.hpp"
#include "host/lower_case.hpp"

namespace morphcl::cli {

int info_command(const InfoOptions& options) {
  const std::string ending = lower_case_extension(options.scene.path);
  if (ending == ".exr")
    print_image_info(options.scene.path, options.json);
  else if (ending == ".png")
    print_png_info(options.scene.path, options.json);
  else
    print_scene_info(open_scene(options.scene), options.json);
  return exit_done;
}

}  // namespace morphcl::cli
