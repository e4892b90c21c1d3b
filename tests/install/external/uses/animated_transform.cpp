#include <morphcl/animated_transform.hpp>

bool use_animated_transform() {
  const morphcl::Track degrees = morphcl::Track::linear({}, {{0, 0.0}, {10, 90.0}});
  morphcl::AnimatedTransform turning;
  turning.rotate_about_axis({0, 0, 0}, {0, 0, 1}, degrees);
  return turning.at(0).matrix() == glm::dmat4(1.0);
}
