// morphcl info: what a shot, a model or an EXR image holds.
#pragma once

#include "cli/scene_options.hpp"

namespace morphcl::cli {

struct InfoOptions {
  SceneOptions scene;  // its path may be an EXR image
  bool json = false;
};

// An image whose pixels do not match the hash stored in it is Error(bad_input), after everything was printed.
int info_command(const InfoOptions& options);

void print_image_info(const std::string& path, bool json);
void print_scene_info(const Scene& scene, bool json);

}  // namespace morphcl::cli
