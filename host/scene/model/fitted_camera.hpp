// What a scene gets that does not say where to look from, how it is lit, or which frames it has.
#pragma once

#include <string>
#include <vector>

#include "morphcl/scene.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

// A three-quarter view that shows everything at every frame of scene.frames.
//
// Perspective, 45 degrees, from the direction (1, 0.8, 1.7), up y. The eye is the nearest one that keeps every object's
// bounds within the middle 70 % of the image's width and height. Bounds are boxes of the morphed meshes (MorphBounds)
// at up to 101 of the frames, evenly spread, the first and the last among them; fewer when there are very many objects.
// Near and far leave room for what moves between them. An empty scene is looked at as a cube of half-edge 1.
//
// Method: in eye axes, a point (x, y, z) lies in the allowed pyramid of the eye e iff z + |y - e.y| / k <= e.z, and the
// same for x; so only the maxima of z + y/k and z - y/k are kept, and they give the best e in closed form.
Camera fitted_camera(const Scene& scene);

// White, from the direction (0.4, 0.7, 0.9).
Light key_light();

// 0 to the last frame at or before the end of every track: its last key, a spring's or an elastic object's when
// it has settled. Frame 0 alone when nothing moves. At most 1,000,000 frames: `warnings` then gets a line.
FrameRange animation_range(const Scene& scene, std::vector<std::string>& warnings);

// Adds to a scene that is complete otherwise what is not `given`.
struct Given {
  bool camera, lights, frames;
};
void complete_scene(Scene& scene, const Given& given);

}  // namespace morphcl
