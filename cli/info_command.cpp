#include "cli/info_command.hpp"

#include <filesystem>

#include "cli/exit_code.hpp"

namespace morphcl::cli {

namespace {
// Of a file name, in lower case.
std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}
}  // namespace

int info_command(const InfoOptions& options) {
  const std::string ending = ending_of(options.scene.path);
  if (ending == ".exr")
    print_image_info(options.scene.path, options.json);
  else if (ending == ".png")
    print_png_info(options.scene.path, options.json);
  else
    print_scene_info(open_scene(options.scene), options.json);
  return exit_done;
}

}  // namespace morphcl::cli
