// morphcl warm: every kernel compiled for a device and kept in the cache.
#pragma once

#include "cli/open_renderer.hpp"

namespace morphcl::cli {

// Error(no_device) when there is none; Error(usage) for the reference renderer, which compiles nothing.
int warm_command(const DeviceOptions& options);

}  // namespace morphcl::cli
