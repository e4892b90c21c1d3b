// What a comparison reports: nothing where nothing is wrong, and every kind of difference where one was made.
#include "lab/frame_error/frame_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lab/frame_error/stored_number.hpp"
#include "morphcl/error.hpp"
#include "morphcl/solids.hpp"
#include "tests/lab/frame_error/compare_frame.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::accuracy {
namespace {

using test::compare_frame;
using test::SceneBuilder;

constexpr int squares_width = 160, squares_height = 90;

// Two squares that fill a part of the picture, one behind the other.
SceneBuilder two_squares() {
  SceneBuilder b(squares_width, squares_height);
  Mesh square;
  square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  b.add(square, Shading::unlit, test::place({0, 0, 1}), {0.5, 0.25, 0.1, 1});
  b.add(square, Shading::unlit, test::place({1.5, 0, 0}), {0.3, 0.3, 0.3, 1});
  b.look({0, 0, 4});
  return b;
}

std::size_t different(const Differences& d) { return d.outline + d.edge + d.order; }

TEST(FrameDifference, AnExactPictureHasTheErrorOfStorageAlone) {
  SceneBuilder b = two_squares();
  const FrameDifference d = compare_frame(b.scene(), b.scene(), 0);
  EXPECT_EQ(different(d.total), 0u);
  ASSERT_EQ(d.objects.size(), 2u);
  EXPECT_EQ(d.objects[0].name, "object 0");
  EXPECT_EQ(d.objects[0].pixels + d.objects[1].pixels, d.total.pixels);
  EXPECT_GT(d.objects[0].pixels, 1000u);
  // At z = 1 the nearer square is 3 away, exactly; its colours 0.5 and 0.25 are halves, 0.1 is not.
  EXPECT_LE(d.objects[0].depth.all.largest, 0x1p-50);
  EXPECT_EQ(d.objects[0].color.storage.largest, std::abs(nearest_half(0.1) - 0.1));
  EXPECT_EQ(d.objects[0].color.all.largest, d.objects[0].color.storage.largest);
  EXPECT_EQ(d.objects[0].color.arithmetic.largest, std::abs(0.1f - 0.1));
  EXPECT_EQ(d.objects[0].color.all.count, 3 * d.objects[0].pixels);
  EXPECT_EQ(d.total.other_color, 0u);
}

TEST(FrameDifference, AnotherColorIsReportedOfItsObject) {
  SceneBuilder b = two_squares();
  Scene drawn = b.scene();
  drawn.objects[1].material.base_color.g += 0.01;
  const FrameDifference d = compare_frame(b.scene(), drawn, 0);
  EXPECT_EQ(different(d.total), 0u);
  EXPECT_NEAR(d.objects[1].color.all.largest, 0.01, half_spacing(0.31));
  EXPECT_NEAR(d.objects[1].color.arithmetic.largest, 0.01, 0x1p-24);
  EXPECT_EQ(d.objects[1].other_color, d.objects[1].pixels);
  EXPECT_LT(d.objects[0].color.all.largest, 0.001);
  // A third of the channels is wrong by 0.01.
  EXPECT_NEAR(d.objects[1].color.arithmetic.rms(), 0.01 / std::sqrt(3.0), 1e-6);
}

TEST(FrameDifference, AnotherPlaceIsReportedAsOutline) {
  SceneBuilder b = two_squares();
  Scene drawn = b.scene();
  drawn.timeline.nodes[0].static_transform[3][0] +=
      2.0 * 3 / (squares_height * 2.414213562);  // one pixel at distance 3
  const FrameDifference d = compare_frame(b.scene(), drawn, 0);
  // A column on the left against the background, one on the right against the square behind.
  EXPECT_GT(d.total.outline, 40u);
  EXPECT_GT(d.total.edge, 40u);
  EXPECT_EQ(d.total.order, 0u);
  EXPECT_EQ(std::count(d.mask.begin(), d.mask.end(), 1.0f), static_cast<std::ptrdiff_t>(d.total.outline));
  EXPECT_EQ(std::count(d.alpha.begin(), d.alpha.end(), 1.0f), static_cast<std::ptrdiff_t>(d.total.outline));
}

TEST(FrameDifference, AnotherDepthOrderIsReportedWithItsGap) {
  SceneBuilder b = two_squares();
  b.scene().timeline.nodes[1].static_transform = test::place({0, 0, 0.999});
  Scene drawn = b.scene();
  drawn.timeline.nodes[1].static_transform = test::place({0, 0, 1.001});
  const FrameDifference d = compare_frame(b.scene(), drawn, 0);
  EXPECT_GT(d.total.order, 500u);
  EXPECT_NEAR(d.total.widest_gap, 0.001 / 3, 1e-9);
  EXPECT_EQ(d.objects[0].order, d.total.order) << "counted for the object that should be seen";
}

TEST(FrameDifference, AMatrixEntryWrongByOnePartIn100000IsFound) {
  const Scene scene = test::pyramid_to_cube(squares_width, squares_height);
  const FrameDifference right = compare_frame(scene, scene, 0);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) {
      Scene wrong = scene;
      double& entry = wrong.timeline.nodes[0].static_transform[column][row];
      if (entry == 0) continue;
      entry *= 1 + 1e-5;
      const FrameDifference d = compare_frame(scene, wrong, 0);
      EXPECT_GT(d.total.depth.arithmetic.rms(), 4 * right.total.depth.arithmetic.rms()) << row << ", " << column;
    }
}

// Planes go through corners that are rounded to 2^-15 pixel: where the same triangle shows, distances are those of the
// true geometry, but for a few roundings.
TEST(FrameDifference, DistancesAreThoseOfTheTrueGeometry) {
  for (const auto& [name, scene, frames] : test::test_scenes(320, 180)) {
    SCOPED_TRACE(name);
    const FrameDifference grid = compare_frame(scene, scene, frames.back()),
                          truth = compare_frame(scene, scene, frames.back(), Truth::true_geometry);
    EXPECT_LE(truth.total.depth.arithmetic.rms(), 4 * grid.total.depth.arithmetic.rms());
    EXPECT_LE(truth.total.depth.arithmetic.largest, 1e-5 + 2 * grid.total.depth.arithmetic.largest)
        << "what is clipped";
  }
}

// Sheets seen so nearly edge-on that a sub-pixel is a long way along them.
TEST(FrameDifference, DistancesOfSteepSheetsAreThoseOfTheTrueGeometry) {
  for (const Shading shading : {Shading::unlit, Shading::smooth})
    for (const double height : {0.02, 0.05, 0.2}) {
      SceneBuilder b(squares_width * 4, squares_height * 4);
      b.add(make_grid({12, 12}), shading, glm::dmat4(1.0), {0.8, 0.5, 0.3, 1}, true);
      const Scene& scene = b.look({0.4, height, 2}).scene();
      const FrameDifference truth = compare_frame(scene, scene, 0, Truth::true_geometry);
      EXPECT_GT(truth.total.depth.all.count, 500u);
      EXPECT_LE(truth.total.depth.arithmetic.largest, 1e-5) << height << ", smooth " << (shading == Shading::smooth);
      EXPECT_LE(truth.total.depth.arithmetic.rms(), 2e-6) << height << ", smooth " << (shading == Shading::smooth);
    }
}

TEST(FrameDifference, FlatFacesHaveOneColorWhereverTheirCornersAreSnappedTo) {
  const Scene scene = test::pyramid_to_cube(squares_width, squares_height);
  EXPECT_LT(compare_frame(scene, scene, 50, Truth::true_geometry).total.color.arithmetic.largest, 0x1p-20);
}

TEST(FrameDifference, PicturesWithoutColorOrDepthAreComparedByWhatTheyHave) {
  Scene scene = test::pyramid_to_cube(squares_width, squares_height);
  scene.image.channels.erase(Channel::color);
  const FrameDifference depth_only = compare_frame(scene, scene, 0);
  EXPECT_EQ(depth_only.total.color.all.count, 0u);
  EXPECT_GT(depth_only.total.depth.all.count, 100u);
  scene.image.channels.insert(Channel::color);
  scene.image.channels.erase(Channel::depth);
  const FrameDifference color_only = compare_frame(scene, scene, 0);
  EXPECT_EQ(color_only.total.depth.all.count, 0u);
  EXPECT_GT(color_only.total.color.all.count, 100u);
}

TEST(FrameDifference, InfiniteColorsAreEqualToInfiniteColors) {
  SceneBuilder b = two_squares();
  b.scene().objects[0].material.base_color = {1e6, 1, 1, 1};
  const FrameDifference d = compare_frame(b.scene(), b.scene(), 0);
  EXPECT_EQ(d.objects[0].color.all.not_finite, d.objects[0].pixels) << "65504 is the largest half";
  EXPECT_EQ(d.objects[0].other_color, 0u) << "what is stored is the nearest half all the same";
}

// A sphere on springs that is still on its way to a cube: neither render may show where the morph alone would be.
TEST(FrameDifference, ElasticObjectsAreComparedInTheShapeTheyHave) {
  SceneBuilder b(squares_width, squares_height);
  b.add(make_sphere_to_cube({12, 6}), Shading::flat);
  Timeline& timeline = b.look({1.6, 1.3, 2.8}).scene().timeline;
  const auto ticks = [&](std::int64_t frame) { return timeline.time.frame_ticks(frame); };
  b.scene().objects[0].morph.tracks.push_back(
      {0,
       Track({Interpolation::linear, 1, false, timeline.time.ticks_per_second(), {ticks(0), ticks(10)}, {0.0, 1.0}})});
  Scene on_rails = b.scene();
  b.scene().objects[0].morph.elastic = Elastic{};
  const FrameDifference d = compare_frame(b.scene(), b.scene(), 5);
  EXPECT_GT(d.total.pixels, 1000u);
  EXPECT_LE(different(d.total), d.total.pixels / 1000);
  EXPECT_LT(d.total.depth.arithmetic.rms(), 1e-6);
  const FrameDifference other = compare_frame(on_rails, on_rails, 5);
  EXPECT_NE(other.total.pixels, d.total.pixels) << "the springs change the picture";
}

TEST(FrameDifference, TooLargeAnImageIsRefused) {
  FramePlan plan;
  plan.width = plan.height = 8192;
  EXPECT_NO_THROW(check_comparable(plan));
  plan.width = 8193;
  EXPECT_THROW(check_comparable(plan), Error);
}

}  // namespace
}  // namespace morphcl::accuracy
