// A small shot, with lines that tests replace.
#pragma once

#include <string>

namespace morphcl::cli_test {

// A cube that moves: 32x18 pixels, frames 0 to 4, every line one that a test may replace.
std::string cube_shot();

// `text` with the first `from` replaced; throws when there is none, so that a test cannot test nothing.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace morphcl::cli_test
