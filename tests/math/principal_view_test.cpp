#include "morphcl/camera.hpp"

#include "tests/math/check.hpp"

namespace morphcl {
namespace {

TEST(PrincipalView, AreTheCamerasThatLookAlongTheAxes) {
  const struct {
    PrincipalView view;
    glm::dvec3 direction, up;
  } cases[] = {{PrincipalView::front, {0, 0, -1}, {0, 1, 0}}, {PrincipalView::back, {0, 0, 1}, {0, 1, 0}},
               {PrincipalView::right, {-1, 0, 0}, {0, 1, 0}}, {PrincipalView::left, {1, 0, 0}, {0, 1, 0}},
               {PrincipalView::top, {0, -1, 0}, {0, 0, -1}},  {PrincipalView::bottom, {0, 1, 0}, {0, 0, 1}}};
  for (const auto& c : cases)
    EXPECT_EQ(world_to_eye(c.view), look_along({0, 0, 0}, c.direction, c.up).world_to_eye) << static_cast<int>(c.view);
}

// The pyramid's apex (100, 100, 100) above its base corner (50, 150, 30), seen from three sides.
TEST(PrincipalView, ThreeViewsOfThePyramid) {
  const glm::dvec3 corner(50, 150, 30);
  expect_point(transform_point(world_to_eye(PrincipalView::front), corner), {50, 150, 30}, 0, "front");
  expect_point(transform_point(world_to_eye(PrincipalView::top), corner), {50, -30, 150}, 0, "top");
  expect_point(transform_point(world_to_eye(PrincipalView::right), corner), {-30, 150, 50}, 0, "right");
}

}  // namespace
}  // namespace morphcl
