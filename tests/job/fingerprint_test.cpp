#include "host/job/fingerprint.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/job/fake_renderer.hpp"

namespace morphcl {
namespace {

using job_test::empty_scene;

TEST(Fingerprint, EverythingThatDecidesTheFileChangesIt) {
  std::set<std::string> seen{fingerprint(empty_scene())};
  const std::function<void(Scene&)> changes[] = {
      [](Scene& s) { s.content_hash = "other"; },
      [](Scene& s) { s.image.width += 1; },
      [](Scene& s) { s.image.height += 1; },
      [](Scene& s) { s.image.color = false; },
      [](Scene& s) { s.image.depth = false; },
      [](Scene& s) { s.image.compression = "zip"; },
      [](Scene& s) { s.image.depth_format = DepthFormat::fixed24; },
      [](Scene& s) { s.accuracy_pixels = 0.01; },
      [](Scene& s) { s.timeline.time.fps_numerator = 24; },
      [](Scene& s) { s.timeline.time.fps_denominator = 2; },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    Scene scene = empty_scene();
    changes[i](scene);
    EXPECT_TRUE(seen.insert(fingerprint(scene)).second) << "change " << i;
  }
}

TEST(Fingerprint, NamesAndFrameRangesDoNot) {
  Scene scene = empty_scene();
  scene.name = "other";
  scene.frames = {{1, 7, 2}};
  scene.warnings = {"something"};
  EXPECT_EQ(fingerprint(scene), fingerprint(empty_scene()));
  EXPECT_EQ(fingerprint(scene).size(), 32u);
}

}  // namespace
}  // namespace morphcl
