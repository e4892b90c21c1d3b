// Which scene a command works on: the shot or model, and what the command line says otherwise about its image and time.
#pragma once

#include <optional>
#include <string>

#include "morphcl/scene.hpp"

namespace morphcl::cli {

// What is absent stays as the shot has it.
struct SceneOptions {
  std::string path;                                     // .toml, .gltf, .glb or .obj
  std::optional<std::string> size;                      // "1920x1080"
  std::optional<std::string> channels;                  // "RGBA,Z"
  std::optional<std::string> channel_names;             // "nuke"
  std::optional<std::string> compression;               // "zip"
  std::optional<std::string> samples;                   // "4"
  std::optional<std::string> depth_buffer;              // "fixed24"
  std::optional<std::string> visibility;                // "painter"
  std::optional<std::string> z_error, p_error;          // "1e-6"
  std::optional<std::string> n_error;                   // "1e-3"
  std::optional<std::string> fps;                       // "25", "30000/1001"
  std::optional<std::string> animation, camera, scene;  // of a glTF model, by name or index
  std::optional<std::string> view;                      // "front"
  bool allow_outside = false;
};

// Loads the scene with these options in it. Errors of the options come before the file is opened.
Scene open_scene(const SceneOptions& options);

void print_warnings(const Scene& scene);  // one line each, to stderr

}  // namespace morphcl::cli
