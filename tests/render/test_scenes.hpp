// Scenes that put every stage of rendering to the test, made here and small enough for the reference renderer.
#pragma once

#include <string>
#include <vector>

#include "morphcl/scene.hpp"

namespace morphcl::test {

struct TestScene {
  std::string name;
  Scene scene;
  std::vector<std::int64_t> frames;
};

// Each named after what it is there for. All of them are drawn at `width` x `height`. The first soup has 3000
// triangles, the others have `more_soup`.
std::vector<TestScene> test_scenes(int width, int height, int more_soup = 3000);

// Triangles around one line, of which many are thinner on the screen than a sub-pixel.
Mesh needles(std::size_t count);

// Triangles of all sizes and directions around a camera, many of them behind it, across the near plane and far outside.
Scene triangle_soup(unsigned seed, int triangles, int width, int height);

// The pyramid that becomes a box in steps 0 to 100, lit flat, while it turns.
Scene pyramid_to_cube(int width, int height);

// About half of its objects let through what lies behind them, some of them at each vertex differently.
Scene transparent(Scene scene, unsigned seed);

}  // namespace morphcl::test
