// Spot lights: the device has the reference's bits, and both the light that the cone lets through.
#include <algorithm>
#include <cmath>

#include "morphcl/numerics.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

constexpr int spot_width = 200, spot_height = 150;

Light spot_from(const glm::dvec3& position, const glm::dvec3& target, double inner, double outer) {
  Light light;
  light.kind = LightKind::point;
  light.vector = position;
  light.spot = SpotBeam{target, {}, inner, outer};
  return light;
}

Scene floor_and_ball(Shading shading, const Light& light) {
  SceneBuilder builder(spot_width, spot_height);
  builder.look({2, 4, 5}).no_lights();
  builder.add(make_grid({9, 9}), shading, place({0, 0, 0}, 3));
  builder.add(make_sphere({24, 16}), shading, place({0.5, 0.6, 0}, 0.5), {0.9, 0.2, 0.3, 1}, true);
  Scene scene = builder.scene();
  scene.timeline.lights = {light};
  return scene;
}

FrameBuffer drawn_plan(Renderer& renderer, const Plan& plan, ChannelSet channels) {
  FrameBuffer frame((*plan).width, (*plan).height, channels);
  renderer.render(plan, frame);
  return frame;
}

TEST(SpotLight, DeviceHasTheBitsOfTheReference) {
  const auto device = make_device_renderer(shared_session());
  const auto reference = make_reference_renderer();
  Light falling = spot_from({0, 3, 1}, {0.5, 0, 0}, 10, 25), narrow = spot_from({-2, 2, 0}, {0, 0, 0}, 5, 5.01),
        inside = spot_from({0.5, 0.6, 0}, {1, 0, 0}, 0, 90), at_the_floor = spot_from({1, 0, 1}, {0, 0, 0}, 20, 80);
  falling.falloff = true;
  for (const Shading shading : {Shading::flat, Shading::smooth})
    for (const Light& light : {falling, narrow, inside, at_the_floor})
      for (const int samples : {1, 4}) {
        Scene scene = floor_and_ball(shading, light);
        scene.image.samples = samples;
        const Planner planner(scene);
        device->forget();
        reference->forget();
        const Plan plan = planner.plan(0);
        const FrameBuffer expected = drawn_plan(*reference, plan, {Channel::color, Channel::depth});
        EXPECT_TRUE(same_pixels(expected, drawn_plan(*device, plan, {Channel::color, Channel::depth})));
        EXPECT_GT(covered_pixels(expected), 5000u);
      }
}

// Of the floor alone, its normal (0, 1, 0): the cosine there times c^2, from the position that the P channel tells.
// Half has 11 bits; fp32 and P add far less to that where the cone is not narrower than a degree.
TEST(SpotLight, LightsWhatItsConesSay) {
  constexpr double half_ulp = 0x1p-11, fp32 = 0x1p-16;
  const glm::dvec3 from(0.5, 2, -0.25), target(-0.5, 0, 0.5);
  const double inner = 12, outer = 30, degree = std::acos(-1.0) / 180;
  Scene scene = floor_and_ball(Shading::smooth, spot_from(from, target, inner, outer));
  scene.objects.pop_back();
  scene.timeline.ambient = glm::dvec3(0);
  scene.image.channels = {Channel::color, Channel::position};
  const FrameBuffer frame = drawn_plan(*make_reference_renderer(), plan_frame(scene, 0), scene.image.channels);
  int whole = 0, part = 0, dark = 0;
  for (int y = 0; y < spot_height; ++y)
    for (int x = 0; x < spot_width; ++x) {
      const auto at = static_cast<std::size_t>(x);
      if (frame.color_row(3, y)[at] == 0) continue;
      const glm::dvec3 p(frame.float_row(Channel::position, 0, y)[at], frame.float_row(Channel::position, 1, y)[at],
                         frame.float_row(Channel::position, 2, y)[at]);
      const glm::dvec3 ray = glm::normalize(p - from);
      const double cosine = glm::dot(ray, glm::normalize(target - from));
      const double ramp = (cosine - std::cos(outer * degree)) / (std::cos(inner * degree) - std::cos(outer * degree));
      const double share = std::pow(std::clamp(ramp, 0.0, 1.0), 2);
      const double expected = 0.8 * share * -ray.y;
      ASSERT_NEAR(from_half(frame.color_row(0, y)[at]), expected, half_ulp * expected + fp32) << x << ' ' << y;
      (share == 1 ? whole : share == 0 ? dark : part) += 1;
    }
  EXPECT_GT(whole, 300);
  EXPECT_GT(part, 300);
  EXPECT_GT(dark, 300);
}

}  // namespace
}  // namespace morphcl::test
