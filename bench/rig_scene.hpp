// A mesh with many morph targets of which few are used, as rigs of characters have them.
#pragma once

#include "morphcl/scene.hpp"

namespace morphcl::bench {

inline constexpr int max_active_targets = 5;

// A sphere of 160 x 80 quads with `targets` targets of positions and normals. Five of them (or all, where there are
// fewer), spread over the list, have weights that move from frame to frame; from 5 targets on, these five and the
// pictures are the same whatever `targets` is. Camera and light are those of the scene "heavy". Error(usage) unless
// `targets` is from 1 to 4096. `width`, `height` 0: 1920 x 1080.
Scene rig_scene(int targets, int width, int height, int frames);

}  // namespace morphcl::bench
