#include <morphcl/convention.hpp>

bool use_convention() {
  const glm::dmat4 own(1.0);
  return morphcl::transform_from(morphcl::row_left_handed, morphcl::transform_to(morphcl::row_left_handed, own)) == own;
}
