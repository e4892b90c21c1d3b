#include "demos/viewer/eye_lights.hpp"

#include <gtest/gtest.h>

namespace morphcl::viewer {
namespace {

// Two world-to-eye matrices with entries within 2^-50, the inverse of one, and two products: below 2^-44 of what they
// act on, vectors no longer than 16.
constexpr double kBound = 0x1p-40;

glm::dvec4 before_eye(const Timeline& timeline, const LightState& light) {
  return evaluate(timeline, 0).camera.world_to_eye * glm::dvec4(light.vector, light.kind == LightKind::point ? 1 : 0);
}

TEST(EyeLights, KeepTheirPlaceBeforeTheEye) {
  Timeline timeline;
  timeline.camera.eye = {1, 2, 8};
  timeline.lights.resize(2);
  timeline.lights[0].vector = {0, 0, 6};
  timeline.lights[1].kind = LightKind::point;
  timeline.lights[1].vector = {3, -1, 2};
  timeline.lights[1].color = {0.5, 0.25, 1};
  timeline.lights[1].falloff = true;

  Timeline moved = timeline;
  moved.camera.eye = {-4, 3, -5};
  moved.camera.target = {1, 0, 0};
  moved.camera.up = {1, 1, 0};
  moved.lights = lights_before_eye(timeline, 0, moved.camera);

  const FrameState before = evaluate(timeline, 0), after = evaluate(moved, 0);
  ASSERT_EQ(after.lights.size(), before.lights.size());
  for (std::size_t i = 0; i < before.lights.size(); ++i) {
    const glm::dvec4 expected = before_eye(timeline, before.lights[i]), actual = before_eye(moved, after.lights[i]);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], kBound) << "light " << i << " component " << c;
    EXPECT_EQ(after.lights[i].color, before.lights[i].color);
    EXPECT_EQ(after.lights[i].falloff, before.lights[i].falloff);
  }
}

TEST(EyeLights, OfAnEyeThatStaysAreWhatTheyWere) {
  Timeline timeline;
  timeline.camera.eye = {0, 0, 8};
  timeline.lights.resize(1);
  timeline.lights[0].vector = {0, 0, 6};
  EXPECT_EQ(lights_before_eye(timeline, 0, timeline.camera)[0].vector, glm::dvec3(0, 0, 1));
}

}  // namespace
}  // namespace morphcl::viewer
