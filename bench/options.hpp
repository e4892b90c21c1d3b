// The command line that the compared programs share: SCENE [--frames N] [--threads N] [--size WxH].
#pragma once

#include <optional>
#include <string>

namespace morphcl::bench {

struct Options {
  std::string scene;
  int frames = 0;             // 0: as many as the scene names
  int threads = 0;            // at least 1 once parsed
  int width = 0, height = 0;  // pixels; 0: the scene's own
};

// Nothing where only help was asked for and printed. Error(usage) otherwise says what is wrong.
std::optional<Options> parse_options(int argc, char** argv, const std::string& description);

}  // namespace morphcl::bench
