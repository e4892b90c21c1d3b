// The default lights: from every side that a fitted camera looks from, white things are neither black nor clipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "host/scene/model/fitted_camera.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

constexpr int min_level = 40, max_level = 250;  // of 255, in a preview

Scene white(const std::string& mesh, const std::string& shading, const std::string& view) {
  const test_support::TemporaryFolder folder;
  folder.write("white.toml", "[image]\nsize = [96, 72]\n[[object]]\nmesh = \"" + mesh + "\"\nshading = \"" + shading +
                                 "\"\ncolor = [1, 1, 1]\n");
  LoadOptions options;
  options.view = view;
  return load_scene((folder.path() / "white.toml").string(), options);
}

// The levels of all that is drawn.
std::set<int> levels(const Scene& scene) {
  FrameBuffer frame(scene.image.width, scene.image.height, scene.image.channels);
  make_reference_renderer()->render(plan_frame(scene, 0), frame);
  const std::vector<std::uint8_t> pixels = to_srgb8(frame);
  std::set<int> found;
  for (std::size_t i = 0; i < pixels.size(); i += 4)
    if (pixels[i + 3] != 0) found.insert({pixels[i], pixels[i + 1], pixels[i + 2]});
  return found;
}

TEST(DefaultLights, ShowEveryFaceOfWhiteSolidsFromEveryView) {
  for (const char* mesh : {"cube", "sphere"})
    for (const char* shading : {"flat", "smooth"})
      for (const char* view : {"three_quarter", "front", "back", "left", "right", "top", "bottom"}) {
        const std::set<int> found = levels(white(mesh, shading, view));
        ASSERT_FALSE(found.empty());
        EXPECT_GE(*found.begin(), min_level) << mesh << " " << shading << " " << view;
        EXPECT_LE(*found.rbegin(), max_level) << mesh << " " << shading << " " << view;
      }
}

double light_on(const glm::dvec3& normal) {
  double sum = default_ambient.x;
  for (const Light& light : default_lights())
    sum += light.color.x * std::max(0.0, glm::dot(normal, glm::normalize(light.vector)));
  return sum;
}

// So that no direction of a camera and no shape can have other levels.
TEST(DefaultLights, LightEveryNormalWithinTheLevels) {
  test_support::Random random(1);
  const auto level = [](double linear) { return 255 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055); };
  for (int i = 0; i < 100'000; ++i) {
    const glm::dvec3 normal = glm::normalize(random.vector(1));
    EXPECT_GT(level(light_on(normal)), min_level);
    EXPECT_LT(level(light_on(normal)), max_level);
  }
}

// Where two faces meet, they must not look like one.
TEST(DefaultLights, TellAdjacentFacesOfACubeApart) {
  const std::array<glm::dvec3, 6> normals = {glm::dvec3(1, 0, 0),  glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0),
                                             glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1),  glm::dvec3(0, 0, -1)};
  for (const glm::dvec3& a : normals)
    for (const glm::dvec3& b : normals)
      if (glm::dot(a, b) == 0) {
        EXPECT_GT(std::abs(light_on(a) / light_on(b) - 1), 0.08) << a.x << a.y << b.x << b.y;
      }
}

TEST(DefaultLights, AreUsedWhereTheShotHasNone) {
  const test_support::TemporaryFolder folder;
  const auto timeline = [&](const std::string& top) {
    folder.write("a.toml", top + "\n[[object]]\nmesh = \"cube\"\n");
    return load_scene((folder.path() / "a.toml").string()).timeline;
  };
  EXPECT_EQ(timeline("").lights.size(), 3u);
  EXPECT_EQ(timeline("").ambient, default_ambient);
  EXPECT_EQ(timeline("ambient = [0, 0, 1]").lights.size(), 3u);
  EXPECT_EQ(timeline("ambient = [0, 0, 1]").ambient, glm::dvec3(0, 0, 1));
  EXPECT_EQ(timeline("light = []").lights.size(), 0u);
  EXPECT_EQ(timeline("light = []").ambient, glm::dvec3(0.05));
  EXPECT_EQ(timeline("[[light]]\ndirection = [0, 0, 1]").lights.size(), 1u);
  EXPECT_EQ(timeline("[[light]]\ndirection = [0, 0, 1]").ambient, glm::dvec3(0.05));
}

}  // namespace
}  // namespace morphcl::test
