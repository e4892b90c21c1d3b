// Lines that show where a perspective's vanishing points are: objects like any other, so that renderers need no special
// case for them.
#pragma once

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/scene.hpp"

namespace morphcl {

// Whether a [camera] table asks for the marks. Fails where they cannot be: in a parallel projection, and where a track
// moves the eye, the target or up.
bool marks_vanishing_points(const ShotTable& camera_table, const Camera& camera);

// Adds one wireframe object for each vanishing point of the scene's first frame, x in red, y in green, z in blue: from
// the four edges of the scene's bounding box that are parallel to the axis lines lead to the point, and a cross stands
// there. The scene is complete, with its camera and frames.
//
// Method: the image of a line that runs to infinity is that of a segment to any point of the line of sight through the
// vanishing point. The one as far away as the farthest part of the scene is taken, so the marks are between near and
// far, and behind what hides them.
void add_vanishing_marks(Scene& scene);

}  // namespace morphcl
