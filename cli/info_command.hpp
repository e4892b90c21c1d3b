// morphcl info: what a shot, a model, an EXR or a PNG image holds.
#pragma once

#include "cli/scene_options.hpp"

namespace morphcl::cli {

struct InfoOptions {
  SceneOptions scene;  // its path may be an EXR or PNG image
  bool json = false;
};

// An image whose pixels do not match the hash stored in it is Error(bad_input), after everything was printed.
int info_command(const InfoOptions& options);

void print_image_info(const std::string& path, bool json);
void print_png_info(const std::string& path, bool json);
// Error(bad_input) unless the hash that is stored, if one is, is that of the pixels.
void require_stored_hash(const std::string& path, const std::string& stored, const std::string& hash);
void print_scene_info(const Scene& scene, bool json);

}  // namespace morphcl::cli
