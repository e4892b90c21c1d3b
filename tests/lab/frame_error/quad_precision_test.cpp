// fp64 is enough to judge fp32: the same render with 113 bits shows the same primitives, and differs by so little that
// no figure of a comparison changes.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <type_traits>

#include "lab/frame_error/precise_frame.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::accuracy {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

// 2^16 times below the spacing of floats, 2^29 times below that of halves.
constexpr double enough = 0x1p-40;

template <template <class> class Geometry>
void expect_same_render(const Scene& scene, std::int64_t frame) {
  constexpr bool on_grid = std::is_same_v<typename Geometry<double>::Coordinate, std::int64_t>;
  const typename Geometry<double>::Coordinate at_an_edge =
      on_grid ? 0 : static_cast<typename Geometry<double>::Coordinate>(0x1p-20);
  const PreciseFrame<Geometry<double>> fp64(scene, frame);
  const PreciseFrame<Geometry<Quad>> quad(scene, frame);
  const auto visible = fp64.find_visible();
  const auto truth = quad.find_visible();
  const int width = scene.image.width;
  double worst_distance = 0, worst_color = 0;
  std::size_t at_edges = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    const bool shows = visible[i].object != no_object, truth_shows = truth[i].object != no_object;
    if (!shows && !truth_shows) continue;
    // Where an edge goes through a pixel's centre, a rounding decides; on the grid no edge is rounded.
    const auto hit = truth_shows ? fp64.hit(truth[i].object, truth[i].primitive, x, y) : std::nullopt;
    if (!hit) {
      ASSERT_FALSE(on_grid) << x << ", " << y;
      ASSERT_FALSE(truth_shows ? quad.covers_around(truth[i].object, truth[i].primitive, x, y, at_an_edge)
                               : fp64.covers_around(visible[i].object, visible[i].primitive, x, y, at_an_edge))
          << x << ", " << y;
      ++at_edges;
      continue;
    }
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
  EXPECT_LE(at_edges, static_cast<std::size_t>(width + scene.image.height)) << "no more than a row and a column";
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
