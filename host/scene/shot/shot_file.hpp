// The shot file: a scene described in TOML (docs/shot-file.md).
#pragma once

#include <string>
#include <string_view>

#include "morphcl/scene.hpp"

namespace morphcl {

// Reads a shot and every file it names. The camera, lights and frames that it does not give are those of
// complete_scene (host/scene/model/fitted_camera.hpp). Error(cannot_read) for the shot itself; everything wrong in it
// is Error(bad_input) at "file:line:column", in a model that it names at the importer's place.
Scene read_shot(const std::string& path, const LoadOptions& options);

// The same for the text of a shot that would lie at `path`.
Scene read_shot_text(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace morphcl
