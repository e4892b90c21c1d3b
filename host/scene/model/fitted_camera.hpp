// What a scene gets that does not say where to look from, how it is lit, or which frames it has.
#pragma once

#include <string>
#include <vector>

#include "host/scene/model/named_view.hpp"
#include "morphcl/camera.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

// Where a fitted camera looks from, and what it leaves as it is.
struct CameraFit {
  ViewDirection view = needed_view(view_names[0]);
  bool near = true, far = true;  // fitted too
};

// Places the scene's camera, whose projection is given, so that it shows everything at every frame of
// scene.frames: what is drawn, at all frames together (DrawnPoints), lies in the middle of the picture and fills 80 %
// of its width or of its height, whichever is filled first (outline_fit.hpp). Perspectives keep their field of view;
// the windows of frustums and central projections show 45 degrees, those of parallel ones what is drawn. Near and far
// leave room. An empty scene is looked at as a cube of half-edge 1.
void fit_camera(Scene& scene, const CameraFit& fit = {});

// What lights a scene that has no light: white, in the world's axes, nothing but sums of what scenes can have.
//   key      0.62 from (0.4, 0.7, 0.9), to the right of and above the viewer of a three-quarter view
//   fill     0.34 from (-0.6, -0.5, -0.75): what faces away from the key light has shape, too
//   hemisphere: sky, 0.2 from (0, 1, 0), and ground, 0.1 of ambient light
// On white the sum is 0.1 to 0.86 for every normal, so that no preview clips and none is black.
std::vector<Light> default_lights();
constexpr glm::dvec3 default_ambient{0.1};

// 0 to the last frame at or before the end of every track: its last key, a spring's or an elastic object's when
// it has settled. Frame 0 alone when nothing moves. At most 1,000,000 frames: `warnings` then gets a line.
FrameRange animation_range(const Scene& scene, std::vector<std::string>& warnings);

// Adds to a scene that is complete otherwise what is not `given`: the camera by fit_camera(), default_ambient with the
// default lights alone.
struct Given {
  bool camera, lights, frames;
  bool ambient = false;
};
void complete_scene(Scene& scene, const Given& given, const CameraFit& fit = {});

}  // namespace morphcl
