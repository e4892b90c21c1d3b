#include "lab/accuracy/operations/operations.hpp"

namespace morphcl::accuracy {

std::vector<Operation> all_operations() {
  return {matrix_rotation(),
          matrix_look_at(),
          matrix_projection(),
          matrix_oblique(),
          matrix_axonometric(),
          matrix_scale_about(),
          matrix_shear(),
          compose(),
          point_transform(),
          divide(),
          viewport_snap(),
          clip(),
          coverage(),
          interpolation(),
          depth(),
          normal(),
          face_normal(),
          lerp_morph(),
          slerp_rotation(),
          rotation_angle(),
          hermite(),
          spring(),
          spring_chain(),
          point_in_polygon(),
          whole_frame(),
          antialiasing(),
          blending()};
}

}  // namespace morphcl::accuracy
