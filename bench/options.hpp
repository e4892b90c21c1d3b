// The command line that the compared programs share: SCENE [--amount N] [--frames N] [--threads N] [--size WxH]
// [--samples N]. A program may have more options.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace morphcl::bench {

struct Options {
  std::string scene;
  int amount = 0;             // 0: the scene's own; see make_bench_scene
  int frames = 0;             // 0: as many as the scene names
  int threads = 0;            // at least 1 once parsed
  int width = 0, height = 0;  // pixels; 0: the scene's own
  int samples = 1;            // a pixel: 1, 2, 4, 8 or 16
};

// Nothing where only help was asked for and printed. Error(usage) otherwise says what is wrong. `add_options` adds the
// options that only this program has.
std::optional<Options> parse_options(int argc, char** argv, const std::string& description,
                                     const std::function<void(CLI::App&)>& add_options = {});

}  // namespace morphcl::bench
