// Where the shots of the demos lie.
#pragma once

#include <string>

namespace morphcl::viewer {

// The file NAME among the installed shots beside this program (../share/morphcl/demos), else in the source folder that
// the program was built from. Error(cannot_read) names both places.
std::string find_shot(const std::string& name);

}  // namespace morphcl::viewer
