// How a [camera] table projects: its projection, fields of view, window and distances.
#pragma once

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/camera.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

enum class ProjectionForm { perspective, frustum, central, orthographic, oblique, axonometric };

// A value of the key `projection`.
struct ProjectionKind {
  std::string_view name;
  ProjectionForm form;
};

// The kind that the table names, "perspective" when it names none. Fails for a key that this kind has no use for.
ProjectionKind read_projection_kind(const ShotTable& camera);

// `target_distance`: from the eye to the target. The picture's plane of a central or oblique projection leads through
// the target. Where the camera is not `placed` only one of near and far need be given; the other is any that fits.
Projection read_projection(const ShotTable& camera, const ProjectionKind& kind, double target_distance, bool placed);

// Where an axonometric projection is seen from.
ViewDirection read_axonometric_direction(const ShotTable& camera, const ProjectionKind& kind);

}  // namespace morphcl
