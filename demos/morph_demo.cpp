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
  const morphcl::viewer::DemoSettings deck{
      .name = "morph_demo",
      .description = "The lecture's own picture: white lines on black that turn by half a degree a tick",
      .shot = "deck.toml",
      .width = 600,
      .height = 600,
      .turning = morphcl::viewer::Turning{.axis = {1, 0, 1}, .degrees_a_tick = 0.5, .ticks_per_second = 100},
  };
  return morphcl::viewer::run_demo(settings, argc, argv, &deck);
}
