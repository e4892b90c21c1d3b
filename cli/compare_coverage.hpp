// morphcl compare --truth coverage: what samples miss of the exact areas of surfaces in pixels.
#pragma once

#include <vector>

#include "cli/compare_command.hpp"

namespace morphcl::cli {

// No picture is drawn: samples are decided by the reference renderer, whose bits every device has.
int compare_coverage(const CompareOptions& options, const Scene& scene, const std::vector<std::int64_t>& frames);

}  // namespace morphcl::cli
