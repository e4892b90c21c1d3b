// Exact coverage of whole frames: what reaches the pixels, and that areas add up.
#include <gtest/gtest.h>

#include "lab/exact_coverage/coverage_error.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/sample_pictures.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::accuracy {
namespace {

using test::flat_picture;
using test::place;
using test::polygon;
using test::SceneBuilder;

// A plan and the scene that it leans on.
struct PlannedScene {
  const Scene scene;
  const Plan plan;
  PlannedScene(const Scene& of, std::int64_t frame) : scene(scene_for_coverage(of)), plan(plan_frame(scene, frame)) {}
};

// Area of each pixel that shows something.
std::vector<double> shown_areas(const Scene& scene, std::int64_t frame = 0) {
  const PlannedScene planned(scene, frame);
  const Plan& plan = planned.plan;
  const ExactCoverage exact(*plan);
  std::vector<double> areas;
  for (int y = 0; y < plan->height; ++y)
    exact.for_each_in_row(y, [&](int x, const PixelCoverage<double>& coverage) {
      EXPECT_EQ(areas.size(), static_cast<std::size_t>(y) * plan->width + x);
      CoverageUnits sum = 0, shown = 0;
      for (const SurfacePart& part : coverage.parts()) {
        sum += part.area;
        if (part.draw != nothing_drawn) shown += part.area;
      }
      EXPECT_EQ(sum, whole_pixel) << x << ", " << y;
      areas.push_back(pixels_of(shown));
    });
  return areas;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

TEST(ExactCoverage, OfPolygonsIsTheirArea) {
  SceneBuilder b = flat_picture(20, 12);
  b.add(polygon({{2.25, 1.5}, {17.75, 3.125}, {9.5, 10.75}}, 20, 12), Shading::unlit, glm::dmat4(1), {1, 1, 1, 1},
        true);
  const std::vector<double> areas = shown_areas(b.scene());
  const double area = 0.5 * ((17.75 - 2.25) * (10.75 - 1.5) - (9.5 - 2.25) * (3.125 - 1.5));
  EXPECT_NEAR(sum_of(areas), area, 240 * 0x1p-44);
}

TEST(ExactCoverage, OfALineIsItsLengthTimesItsWidth) {
  for (const bool steep : {false, true}) {
    SceneBuilder b = flat_picture(20, 20);
    Mesh mesh = steep ? polygon({{5, 3}, {8, 17}}, 20, 20) : polygon({{3, 5}, {17, 8}}, 20, 20);
    mesh.edges = {{0, 1}};
    b.add(mesh, Shading::wireframe);
    b.scene().objects[0].material.line_width = 2;
    // Half its thickness is rounded to sub-pixels, for a run of 14 pixels.
    EXPECT_NEAR(sum_of(shown_areas(b.scene())), 2 * std::sqrt(14.0 * 14 + 3 * 3), 14.0 / 256) << steep;
  }
}

// Rows and columns that a polygon is looked for in are all that it reaches: the same pixels find the same areas among
// all polygons of the frame.
TEST(ExactCoverage, LooksForPolygonsWhereTheyAre) {
  for (const auto& [name, scene, frames] : test::test_scenes(40, 24)) {
    const PlannedScene planned(scene, frames.back());
    const Plan& plan = planned.plan;
    const std::vector<RasterPolygon> polygons = raster_polygons(*plan);
    if (polygons.size() > 3000) continue;
    std::vector<const RasterPolygon*> all;
    for (const RasterPolygon& p : polygons) all.push_back(&p);
    const ExactCoverage exact(*plan);
    PixelCoverage<double> expected(background_depth_of(*plan));
    for (int y = 0; y < plan->height; y += 3)
      exact.for_each_in_row(y, [&](int x, const PixelCoverage<double>& coverage) {
        ASSERT_TRUE(expected.find(all, x, y));
        ASSERT_EQ(coverage.parts().size(), expected.parts().size()) << name << " " << x << ", " << y;
        for (std::size_t i = 0; i < coverage.parts().size(); ++i) {
          EXPECT_EQ(coverage.parts()[i].area, expected.parts()[i].area);
          EXPECT_EQ(coverage.parts()[i].primitive, expected.parts()[i].primitive);
        }
      });
  }
}

TEST(ExactCoverage, OfEveryDepthFormatIsNearlyTheSame) {
  SceneBuilder b(48, 32);
  b.look({1.1, 1.9, 2.7}).project(Perspective{.fovy_degrees = 45, .near = 0.5, .far = 20});
  b.add(make_solid("teapot"), Shading::flat);
  b.add(make_cube(), Shading::flat, place({0.2, 0.1, 0}, 0.7));
  const std::vector<double> expected = shown_areas(b.scene());
  for (const DepthFormat format : {DepthFormat::forward_float, DepthFormat::fixed16, DepthFormat::fixed32}) {
    b.scene().image.depth_format = format;
    const std::vector<double> areas = shown_areas(b.scene());
    for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(areas[i], expected[i], 0x1p-40);
  }
}

TEST(ExactCoverage, OfAnEmptyFrameIsNothing) {
  SceneBuilder b(9, 5);
  b.look({0, 0, 5});
  EXPECT_EQ(sum_of(shown_areas(b.scene())), 0);
}

TEST(ExactCoverage, OfDegenerateTrianglesIsNothing) {
  SceneBuilder b = flat_picture(8, 8);
  b.add(polygon({{1, 1}, {7, 7}, {4, 4}}, 8, 8), Shading::unlit);            // on a line
  b.add(polygon({{3, 3}, {3, 3}, {3, 3}}, 8, 8), Shading::unlit);            // a point
  b.add(polygon({{3, 3}, {3.0005, 3}, {3, 3.0005}}, 8, 8), Shading::unlit);  // below a sub-pixel
  for (Object& object : b.scene().objects) object.material.double_sided = true;
  EXPECT_EQ(sum_of(shown_areas(b.scene())), 0);
  // Of two that turn their back and their front, one is seen.
  b.add(polygon({{1, 7}, {1, 1}, {7, 1}}, 8, 8), Shading::unlit);
  b.add(polygon({{1, 7}, {7, 1}, {1, 1}}, 8, 8), Shading::unlit);
  EXPECT_NEAR(sum_of(shown_areas(b.scene())), 18, 64 * 0x1p-44);
  b.scene().objects.pop_back();
  b.scene().objects.back().material.double_sided = true;
  EXPECT_NEAR(sum_of(shown_areas(b.scene())), 18, 64 * 0x1p-44);
}

TEST(ExactCoverage, OfWhatLiesOutsideIsNothing) {
  SceneBuilder b = flat_picture(8, 8);
  b.add(polygon({{-100, -100}, {-1, -100}, {-1, 200}}, 8, 8), Shading::unlit, glm::dmat4(1), {1, 1, 1, 1}, true);
  b.add(polygon({{8, 0}, {9000, 0}, {8, 9000}}, 8, 8), Shading::unlit, glm::dmat4(1), {1, 1, 1, 1}, true);
  EXPECT_EQ(sum_of(shown_areas(b.scene())), 0) << "one at a distance, one along the picture's side";
}

TEST(ExactCoverage, OfTheWidestImageAndTheLargestTriangles) {
  for (const bool upright : {false, true}) {
    const int width = upright ? 1 : max_image_size, height = upright ? max_image_size : 1;
    SceneBuilder b = flat_picture(width, height);
    b.add(polygon({{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}}, width, height), Shading::unlit, glm::dmat4(1), {1, 1, 1, 1},
          true);
    const std::vector<double> areas = shown_areas(b.scene());
    EXPECT_EQ(areas.size(), std::size_t{max_image_size});
    // Above the diagonal lies half of the first pixel, and all of the others of a row.
    const double expected = upright ? 0.5 : max_image_size - 0.5;
    EXPECT_NEAR(sum_of(areas), expected, 0.1) << "10^6 pixels away fp32 is a sixteenth of a pixel wide; " << upright;
  }
}

TEST(ExactCoverage, RefusesWhatWouldTakeTooLong) {
  SceneBuilder b = flat_picture(4096, 4096);
  Mesh mesh = polygon({{-1, -1}, {9000, -1}, {-1, 9000}}, 4096, 4096);
  const glm::uvec3 triangle = mesh.triangles.front();
  mesh.triangles.assign(200, triangle);
  b.add(mesh, Shading::unlit, glm::dmat4(1), {1, 1, 1, 1}, true);
  const PlannedScene planned(b.scene(), 0);
  try {
    const ExactCoverage exact(*planned.plan);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("--size"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace morphcl::accuracy
