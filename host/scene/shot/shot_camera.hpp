// The [camera] table of a shot file.
#pragma once

#include <optional>
#include <string>

#include "host/scene/model/fitted_camera.hpp"
#include "host/scene/shot/mesh_library.hpp"
#include "host/scene/shot/parent_links.hpp"
#include "host/scene/shot/shot_track.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "morphcl/scene.hpp"

namespace morphcl {

struct ShotCamera {
  Camera camera;
  bool marks_vanishing_points = false;          // host/scene/shot/vanishing_marks.hpp
  std::optional<CameraFit> fit = std::nullopt;  // where the table does not say where the camera stands
};
// A camera out of a model file comes with its nodes, which are added to the scene, below its parent if it has one.
// `view` is the one that was asked for instead of the table's; Error(usage) where the table places the camera itself.
ShotCamera read_camera(const ShotValue& camera, const std::optional<std::string>& view, TrackReader& tracks,
                       MeshLibrary& library, ParentLinks& parents, Scene& scene);

// The camera of a shot without a table. Error(usage) for a view that there is not.
ShotCamera fitted_shot_camera(const std::optional<std::string>& view);

}  // namespace morphcl
