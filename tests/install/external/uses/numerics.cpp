#include <morphcl/numerics.hpp>

bool use_numerics() {
  return morphcl::from_half(morphcl::to_half(morphcl::cosine(0))) == 1 &&
         morphcl::orientation(glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)) == 1;
}
