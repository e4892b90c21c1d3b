// Command lines to try, for --help. Each works as it is typed in the folder of the repository; a test runs them.
#pragma once

#include <string>
#include <string_view>

namespace morphcl::cli {

// "Examples:" and a line each; of the tool itself for the name "morphcl".
std::string examples_of(std::string_view command);

}  // namespace morphcl::cli
