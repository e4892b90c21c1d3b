// A scene from a file of any kind that can be rendered.
#pragma once

#include <string>

#include "host/scene/model/load_options.hpp"
#include "host/scene/model/scene.hpp"

namespace morphcl {

// By the extension of `path`, in any case: .toml is a shot; .gltf, .glb and .obj are models, drawn as a shot would draw
// them with nothing but the object: camera and lights of the file, else the fitted camera and the key light; frames 0
// to the last one at or before the last key.
//
// The result is valid (host/scene/model/scene.hpp). Errors: cannot_read when the file is missing or unreadable,
// bad_input when it or what it names is wrong, usage for another extension or options out of range.
Scene load_scene(const std::string& path, const LoadOptions& options = {});

}  // namespace morphcl
