// A face-like mesh with many morph targets of which few are used, as rigs of characters have them.
#pragma once

#include "host/scene/scene.hpp"

namespace morphcl::bench {

inline constexpr int active_targets = 5;

// A sphere of 160 x 80 quads with `targets` targets of positions and normals. Five of them, spread over the list, have
// weights that move from frame to frame; whatever `targets` is, these five and the pictures are the same. Camera and
// light are those of the scene "heavy". Error(usage) unless `targets` is from 5 to 4096. `width`, `height` 0: 1920 x
// 1080.
Scene rig_scene(int targets, int width, int height, int frames);

}  // namespace morphcl::bench
