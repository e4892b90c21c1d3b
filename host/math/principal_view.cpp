#include "morphcl/camera.hpp"

namespace morphcl {

namespace {

// From the world directions that the eye's x and y axes point in.
glm::dmat4 rows(const glm::dvec3& x, const glm::dvec3& y) {
  return glm::dmat4(glm::transpose(glm::dmat3(x, y, glm::cross(x, y) + 0.0)));
}

}  // namespace

glm::dmat4 world_to_eye(PrincipalView view) {
  switch (view) {
    case PrincipalView::back:
      return rows({-1, 0, 0}, {0, 1, 0});
    case PrincipalView::left:
      return rows({0, 0, 1}, {0, 1, 0});
    case PrincipalView::right:
      return rows({0, 0, -1}, {0, 1, 0});
    case PrincipalView::top:
      return rows({1, 0, 0}, {0, 0, -1});
    case PrincipalView::bottom:
      return rows({1, 0, 0}, {0, 0, 1});
    case PrincipalView::front:
      break;
  }
  return glm::dmat4(1.0);
}

}  // namespace morphcl
