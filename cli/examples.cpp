#include "cli/examples.hpp"

#include <algorithm>
#include <array>

namespace morphcl::cli {

namespace {

struct Examples {
  std::string_view command, lines;
};

constexpr std::array<Examples, 9> all_examples{{
    {"morphcl", R"(
  morphcl render demos/pyramid_to_cube.toml --frames 0-100x25 --size 640x360 -o out/cube.####.exr
  morphcl plan demos/pyramid_to_cube.toml --frame 57
  morphcl info out/cube.0050.exr
  morphcl accuracy --quick --operation lerp spring)"},
    {"render", R"(
  morphcl render demos/pyramid_to_cube.toml --frames 0-100x25 --size 640x360 -o out/cube.####.exr
  morphcl render demos/pyramid_to_cube.toml --frames 0-100x10 --size 640x360 -o out/cube.####.exr --resume
  morphcl render demos/wireframe.toml --frames 0-20x5 -o out/wire.####.png --png-bits 16
  morphcl render demos/teapots.toml --frames 0,40,80 --size 320x180 -o out/pots.####.exr --contact-sheet pots.png)"},
    {"plan", R"(
  morphcl plan demos/pyramid_to_cube.toml --frame 57
  morphcl plan demos/teapots.toml --channels RGBA --json
  morphcl plan demos/solids.toml --frame 40 --size 320x180 --visibility warnock --explain out/warnock)"},
    {"trace", R"(
  morphcl trace demos/pyramid_to_cube.toml --frame 37 --vertex 4
  morphcl trace demos/teapots.toml --vectors row --handedness left --ndc-depth zero_to_one
  morphcl trace demos/pyramid_to_cube.toml --frame 50 --size 640x360 --pixel 320,180
  morphcl trace demos/pyramid_to_cube.toml --latex)"},
    {"compare", R"(
  morphcl compare demos/pyramid_to_cube.toml --frames 0-100x50 --size 320x180
  morphcl compare demos/pyramid_to_cube.toml --frame 10 --size 320x180 --truth grid --out out/error
  morphcl compare demos/solids.toml --frame 75 --size 320x180 --truth coverage)"},
    {"info", R"(
  morphcl info demos/teapots.toml
  morphcl info demos/pyramid_to_cube.toml --json)"},
    {"devices", R"(
  morphcl devices
  morphcl devices --threads 1 --json)"},
    {"warm", R"(
  morphcl warm
  morphcl warm demos/solids.toml --samples 4)"},
    {"accuracy", R"(
  morphcl accuracy --quick --operation lerp spring
  morphcl accuracy --quick --operation lerp --verbose
  morphcl accuracy --quick --operation divide --device none --out out/accuracy)"},
}};

}  // namespace

std::string examples_of(std::string_view command) {
  const auto* const found = std::find_if(all_examples.begin(), all_examples.end(),
                                         [command](const Examples& one) { return one.command == command; });
  return found == all_examples.end() ? std::string() : "Examples:" + std::string(found->lines);
}

}  // namespace morphcl::cli
