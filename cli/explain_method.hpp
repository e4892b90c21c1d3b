// --explain DIR: what a frame's hidden-surface method did.
#pragma once

#include <cstdint>
#include <string>

#include "morphcl/planner.hpp"

namespace morphcl::cli {

// Writes the files of the frame and says on stdout what they hold; as JSON one object, of type "explanation".
void explain_method(const Planner& planner, std::int64_t frame, const std::string& folder, bool json);

}  // namespace morphcl::cli
