#include "host/render/plan/half_spaces.hpp"

namespace morphcl {

HalfSpaces::HalfSpaces(std::span<const glm::dvec4> planes, const glm::dmat4& to_clip) {
  for (const glm::dvec4& plane : planes) {
    Plane& p = planes_[count_++];
    for (int column = 0; column < 3; ++column) {
      p.normal[column] = glm::dot(plane, to_clip[column]);
      p.terms[column] = glm::dot(glm::abs(plane), glm::abs(to_clip[column]));
    }
    p.absolute = glm::abs(p.normal);
    p.offset = glm::dot(plane, to_clip[3]);
    p.offset_terms = glm::dot(glm::abs(plane), glm::abs(to_clip[3]));
  }
}

}  // namespace morphcl
