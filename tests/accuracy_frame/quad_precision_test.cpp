// fp64 is enough to judge fp32: the same render with 113 bits shows the same primitives, and differs by so little that
// no figure of a comparison changes.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "host/accuracy/frame/precise_frame.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::accuracy {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

// 2^16 times below the spacing of floats, 2^29 times below that of halves.
constexpr double enough = 0x1p-40;

template <template <class> class Geometry>
void expect_same_render(const Scene& scene, std::int64_t frame) {
  const PreciseFrame<Geometry<double>> fp64(scene, frame);
  const PreciseFrame<Geometry<Quad>> quad(scene, frame);
  const auto visible = fp64.find_visible();
  const auto truth = quad.find_visible();
  const int width = scene.image.width;
  double worst_distance = 0, worst_color = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    ASSERT_EQ(visible[i].object == no_object, truth[i].object == no_object) << x << ", " << y;
    if (truth[i].object == no_object) continue;
    // Of two surfaces at the same distance either may be the nearest by a rounding.
    const auto hit = fp64.hit(truth[i].object, truth[i].primitive, x, y);
    ASSERT_TRUE(hit) << x << ", " << y;
    const double distance = static_cast<double>(truth[i].distance);
    if (visible[i].object != truth[i].object || visible[i].primitive != truth[i].primitive) {
      ASSERT_LE(std::abs(visible[i].distance - distance), enough * std::abs(distance)) << x << ", " << y;
    }
    worst_distance = std::max(worst_distance, std::abs((hit->distance - distance) / distance));
    const auto exact_hit = quad.hit(truth[i].object, truth[i].primitive, x, y);
    const auto color = fp64.color(truth[i].object, truth[i].primitive, *hit, x, y);
    const auto exact = quad.color(truth[i].object, truth[i].primitive, *exact_hit, x, y);
    const double channels[3][2] = {{color.x, static_cast<double>(exact.x)},
                                   {color.y, static_cast<double>(exact.y)},
                                   {color.z, static_cast<double>(exact.z)}};
    for (const auto& [value, expected] : channels)
      worst_color = std::max(worst_color, std::abs(value - expected) / std::max(1.0, std::abs(expected)));
  }
  EXPECT_LE(worst_distance, enough);
  EXPECT_LE(worst_color, enough);
  testing::Test::RecordProperty("worst_relative_distance", std::to_string(std::log2(worst_distance)));
  testing::Test::RecordProperty("worst_color", std::to_string(std::log2(worst_color)));
}

TEST(QuadPrecision, ChangesNothingOnTheGrid) {
  for (const auto& [name, scene, frames] : test::test_scenes(32, 18)) {
    SCOPED_TRACE(name);
    expect_same_render<OnGrid>(scene, frames.back());
  }
}

TEST(QuadPrecision, ChangesNothingInTrueGeometry) {
  for (const auto& [name, scene, frames] : test::test_scenes(32, 18)) {
    SCOPED_TRACE(name);
    expect_same_render<TrueGeometry>(scene, frames.back());
  }
}

}  // namespace
}  // namespace morphcl::accuracy
