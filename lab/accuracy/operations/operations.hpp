// One function an operation of the report; each in a file of its name.
#pragma once

#include "lab/accuracy/operation.hpp"

namespace morphcl::accuracy {

Operation matrix_rotation();
Operation matrix_look_at();
Operation matrix_projection();
Operation matrix_oblique();
Operation matrix_axonometric();
Operation matrix_scale_about();
Operation matrix_shear();
Operation compose();
Operation point_transform();
Operation divide();
Operation viewport_snap();
Operation clip();
Operation coverage();
Operation interpolation();
Operation depth();
Operation normal();
Operation face_normal();
Operation lerp_morph();
Operation slerp_rotation();
Operation rotation_angle();
Operation hermite();
Operation spring();
Operation spring_chain();
Operation point_in_polygon();
Operation whole_frame();
Operation antialiasing();
Operation blending();

}  // namespace morphcl::accuracy
