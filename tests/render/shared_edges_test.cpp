// Surfaces that meet keep their order. Where one turns away from the eye, the triangles on both sides of the edge cover
// the same pixels there, and the one in front shows; of two in one place the one that is drawn first.
#include <gtest/gtest.h>

#include "host/render/frame/raster_grid.hpp"
#include "host/render/frame/scene_vertices.hpp"
#include "host/render/reference/visibility.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

// Pixels, or samples, of a closed convex solid whose back faces are drawn too that show one of them.
struct Shown {
  std::size_t front = 0, back = 0;
};

Shown shown_sides(const Mesh& mesh, const glm::dvec3& eye, DepthFormat format, int samples) {
  SceneBuilder builder(640, 360);
  builder.add(mesh, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
  Scene& scene = builder.look(eye).scene();
  scene.image.depth_format = format;
  const Plan plan = plan_frame(scene, 0);
  const RasterGrid grid(640, 360);
  const auto vertices = reference::project_vertices(plan->draws.at(0), *plan, grid);
  reference::Visibility visible;
  reference::find_visible(*plan, grid, {vertices}, {}, samples, visible);
  Shown shown;
  for (const reference::Sample& sample : visible.samples) {
    if (sample.order == reference::no_order) continue;
    const glm::uvec3 corner = mesh.triangles[sample.primitive];
    const reference::ScreenVertex &a = vertices[corner[0]].screen, &b = vertices[corner[1]].screen,
                                  &c = vertices[corner[2]].screen;
    const std::int64_t area = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
    ++(area < 0 ? shown.front : shown.back);  // y points down
  }
  return shown;
}

TEST(SharedEdges, NoBackOfAConvexSolidShows) {
  for (const auto& [name, mesh] : {std::pair{"cube", make_cube()}, std::pair{"sphere", make_sphere({48, 24})}})
    for (const DepthFormat format : {DepthFormat::reversed_float, DepthFormat::fixed32})
      for (const int samples : {1, 4}) {
        Shown total;
        for (int step = 0; step < 6; ++step) {
          const double turn = 0.1 + 0.71 * step, up = 0.2 + 0.26 * step;
          const Shown shown = shown_sides(mesh, {3 * std::cos(turn), up, 3 * std::sin(turn)}, format, samples);
          total.front += shown.front;
          total.back += shown.back;
        }
        EXPECT_GT(total.front, 100000u);
        EXPECT_EQ(total.back, 0u) << name;
      }
}

// However the two are shaded.
TEST(SharedEdges, OfTwoSurfacesInOnePlaceTheOneDrawnFirstShows) {
  Mesh colored = make_sphere({24, 12});
  colored.colors.assign(colored.positions.size(), glm::vec4(1, 0.5f, 0, 1));
  const std::pair<Mesh, Shading> kinds[] = {{make_sphere({24, 12}), Shading::unlit},
                                            {make_sphere({24, 12}), Shading::flat},
                                            {make_sphere({24, 12}), Shading::smooth},
                                            {colored, Shading::flat}};
  for (const auto& [first, shading_of_first] : kinds)
    for (const auto& [second, shading_of_second] : kinds)
      for (const DepthFormat format : {DepthFormat::reversed_float, DepthFormat::fixed24})
        for (const int samples : {1, 4}) {
          SceneBuilder builder(160, 90);
          builder.add(first, shading_of_first);
          builder.add(second, shading_of_second);
          Scene& scene = builder.look({1.6, 1.1, 2.5}).scene();
          scene.image.depth_format = format;
          const Plan plan = plan_frame(scene, 0);
          const RasterGrid grid(160, 90);
          std::vector<std::vector<reference::Vertex>> vertices;
          for (const Draw& draw : plan->draws) vertices.push_back(reference::project_vertices(draw, *plan, grid));
          reference::Visibility visible;
          reference::find_visible(*plan, grid, vertices, {}, samples, visible);
          std::size_t of_first = 0, of_second = 0;
          for (const reference::Sample& sample : visible.samples)
            if (sample.order != reference::no_order) ++(sample.draw == 0 ? of_first : of_second);
          EXPECT_GT(of_first, 1000u);
          EXPECT_EQ(of_second, 0u) << static_cast<int>(shading_of_first) << static_cast<int>(shading_of_second);
        }
}

}  // namespace
}  // namespace morphcl::test
