#include "morphcl/projection.hpp"

#include <limits>

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

const Viewport whole_image{0, 0, 640, 480};

TEST(Viewport, WorkedExample) {
  const Viewport v{10, 20, 640, 480};
  EXPECT_EQ(v.to_pixels({0, 0}), glm::dvec2(330, 260));
  EXPECT_EQ(v.to_pixels({1, 1}), glm::dvec2(650, 20));
  EXPECT_EQ(v.to_pixels({-0.5, -0.25}), glm::dvec2(170, 320));
  EXPECT_EQ(v.to_pixels({-1, 1}), glm::dvec2(10, 20));
}

TEST(Viewport, RoundTrip) {
  Random random(61);
  for (int i = 0; i < 1000; ++i) {
    const Viewport v{random.in(-100, 100), random.in(-100, 100), random.in(1, 16384), random.in(1, 16384)};
    const glm::dvec2 ndc{random.in(-2, 2), random.in(-2, 2)};
    const glm::dvec2 back = v.to_ndc(v.to_pixels(ndc));
    // A pixel coordinate up to 100 + 1.5 size, rounded once each way, is divided by half the size.
    EXPECT_TRUE(within(back.x, ndc.x, 4 * u64 * (200 + 3 * v.width) / v.width + 2 * u64)) << i;
    EXPECT_TRUE(within(back.y, ndc.y, 4 * u64 * (200 + 3 * v.height) / v.height + 2 * u64)) << i;
  }
}

TEST(Viewport, RightAndLowerEdgesBelongToNoPixel) {
  EXPECT_FALSE(whole_image.pixel_of({1, 0}).has_value());
  EXPECT_FALSE(whole_image.pixel_of({0, -1}).has_value());
  EXPECT_EQ(whole_image.pixel_of({-1, 1}), glm::ivec2(0, 0));
  EXPECT_FALSE(whole_image.pixel_of({std::nextafter(-1.0, -2.0), 0}).has_value());
  EXPECT_FALSE(whole_image.pixel_of({0, std::nextafter(1.0, 2.0)}).has_value());
}

// The coordinate just inside rounds onto the edge; its pixel is still the last one.
TEST(Viewport, JustInsideTheEdgeIsTheLastPixel) {
  EXPECT_EQ(whole_image.pixel_of({std::nextafter(1.0, 0.0), std::nextafter(-1.0, 0.0)}), glm::ivec2(639, 479));
  const Viewport shifted{10, 20, 640, 480};
  EXPECT_EQ(shifted.pixel_of({std::nextafter(1.0, 0.0), std::nextafter(-1.0, 0.0)}), glm::ivec2(649, 499));
}

TEST(Viewport, EveryPixelOfALargeImage) {
  const Viewport large{0, 0, 16384, 16384};
  for (int i = 0; i < 16384; ++i) {
    const double left_edge = i / 8192.0 - 1, centre = (i + 0.5) / 8192.0 - 1;
    EXPECT_EQ(large.pixel_of({left_edge, -left_edge}), glm::ivec2(i, i));
    EXPECT_EQ(large.pixel_of({centre, -centre}), glm::ivec2(i, i));
    EXPECT_EQ(large.to_pixels({centre, -centre}), glm::dvec2(i + 0.5, i + 0.5));
  }
}

TEST(Viewport, HostileInputHasNoPixel) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1e300}) {
    EXPECT_FALSE(whole_image.pixel_of({bad, 0}).has_value()) << bad;
    EXPECT_FALSE(whole_image.pixel_of({0, bad}).has_value()) << bad;
    EXPECT_FALSE((Viewport{bad, 0, 10, 10}).pixel_of({0, 0}).has_value()) << bad;
  }
  EXPECT_FALSE((Viewport{0, 0, 1e18, 10}).pixel_of({0.5, 0}).has_value());
}

}  // namespace
}  // namespace morphcl
