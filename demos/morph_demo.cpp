// The morph from pyramid to cube, step by step: k forward, p back.
#include "demos/viewer/run_demo.hpp"

int main(int argc, char** argv) {
  const morphcl::viewer::DemoSettings settings{
      .name = "morph_demo",
      .description = "Morph a pyramid into a cube in 100 steps; the frames are those of morphcl render.",
      .shot = "pyramid_to_cube.toml",
      .width = 960,
      .height = 540,
  };
  return morphcl::viewer::run_demo(settings, argc, argv);
}
