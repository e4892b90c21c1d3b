// morphcl warm: kernels compiled for a device and kept in the cache, the usual ones or those of a shot.
#pragma once

#include "cli/open_renderer.hpp"
#include "cli/scene_options.hpp"

namespace morphcl::cli {

struct WarmOptions {
  DeviceOptions device;
  SceneOptions scene;  // its path is empty: what frames of one sample a pixel, the default depth buffer and opaque
                       // surfaces may need, whatever they hold
};

// Error(no_device) when there is none; Error(usage) for the reference renderer, which compiles nothing.
int warm_command(const WarmOptions& options);

}  // namespace morphcl::cli
