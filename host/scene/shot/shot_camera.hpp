// The [camera] table of a shot file.
#pragma once

#include "host/scene/shot/mesh_library.hpp"
#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/scene.hpp"

namespace morphcl {

struct ShotCamera {
  Camera camera;
  bool marks_vanishing_points = false;  // host/scene/shot/vanishing_marks.hpp
};
// A camera out of a model file comes with its nodes, which are added to the scene.
ShotCamera read_camera(const ShotValue& camera, TrackReader& tracks, MeshLibrary& library, Scene& scene);

}  // namespace morphcl
