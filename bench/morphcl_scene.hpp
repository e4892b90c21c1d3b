// A benchmark scene as morphcl draws it.
#pragma once

#include "bench/scenes.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::bench {

// t runs linearly from 0 at frame 0 to 1 at frame `frames` - 1; a single frame is t = 0. The image has RGBA and Z.
// Takes the arrays of the shape, which is empty then.
Scene morphcl_scene(BenchScene& bench, int frames);

}  // namespace morphcl::bench
