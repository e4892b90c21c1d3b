// The depth of a pixel lies between those of its primitive's ends, however thin that is and wherever its corners lie
// between sub-pixels: steep sheets and needles, in every depth buffer.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/render/frame/normalized_depth.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/frame/scene_vertices.hpp"
#include "host/render/reference/visibility.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

struct Judged {
  std::size_t samples = 0, outside = 0;
};

// Every sample that shows something.
Judged judge_scene(const Scene& scene, int samples_a_pixel) {
  const Mesh& mesh = scene.meshes[0];
  const DepthFormat format = scene.image.depth_format;
  const bool lines = scene.objects[0].material.shading == Shading::wireframe;
  const Plan plan = plan_frame(scene, 0);
  if (plan->draws.empty()) return {};
  const RasterGrid grid(plan->width, plan->height);
  const auto vertices = reference::project_vertices(plan->draws.at(0), *plan, grid);
  reference::Visibility visible;
  reference::find_visible(*plan, grid, {vertices}, {}, samples_a_pixel, visible);
  const std::vector<glm::uvec2> edges = wireframe_edges(mesh);
  Judged judged;
  for (const reference::Sample& sample : visible.samples) {
    if (sample.order == reference::no_order || sample.piece != reference::no_piece) continue;
    std::vector<std::uint32_t> ends;
    if (lines)
      ends = {edges[sample.primitive][0], edges[sample.primitive][1]};
    else
      for (int i = 0; i < 3; ++i) ends.push_back(mesh.triangles[sample.primitive][i]);
    bool farther = false, nearer = false;
    for (const std::uint32_t end : ends) {
      const float depth = vertices[end].screen.depth;
      if (is_forward(format)) {
        const std::uint32_t key = reference::key_of(reference::normalized_depth_of(depth, *plan), format);
        farther |= key <= sample.key;
        nearer |= key >= sample.key;
      } else {
        farther |= depth <= sample.depth;
        nearer |= depth >= sample.depth;
      }
    }
    ++judged.samples;
    judged.outside += !(farther && nearer);
  }
  return judged;
}

Judged judge(const Mesh& mesh, Shading shading, const glm::dvec3& eye, DepthFormat format, int samples_a_pixel) {
  SceneBuilder builder(320, 180);
  builder.add(mesh, shading, glm::dmat4(1.0), {1, 1, 1, 1}, true);
  Scene& scene = builder.look(eye).scene();
  scene.image.depth_format = format;
  return judge_scene(scene, samples_a_pixel);
}

TEST(DepthRange, IsThatOfThePrimitive) {
  const std::pair<const char*, Mesh> meshes[] = {
      {"needles", needles(3000)}, {"sheet", make_grid({60, 60})}, {"sphere", make_sphere({96, 48})}};
  for (const DepthFormat format : {DepthFormat::reversed_float, DepthFormat::fixed16, DepthFormat::fixed32})
    for (const auto& [name, mesh] : meshes)
      for (const Shading shading : {Shading::unlit, Shading::wireframe}) {
        Judged total;
        for (const double height : {0.003, 0.05, 1.0}) {
          const Judged judged = judge(mesh, shading, {0.3, height, 2.5}, format, 1);
          total.samples += judged.samples;
          total.outside += judged.outside;
        }
        EXPECT_GT(total.samples, 500u) << name;
        EXPECT_EQ(total.outside, 0u) << name << ", " << name_of(format) << ", wireframe "
                                     << (shading == Shading::wireframe);
      }
}

// One triangle a picture: its corners lie within a sub-pixel of a line, and far apart in depth.
TEST(DepthRange, HoldsWhereATriangleIsThinnerThanASubPixel) {
  constexpr int size = 64;
  for (const DepthFormat format : {DepthFormat::reversed_float, DepthFormat::fixed24}) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    Judged total;
    for (int i = 0; i < 8000; ++i) {
      const double slope = unit(random), height = unit(random) * 0.2, thickness = 1.0 / 256 * 2 / size;
      Mesh mesh;
      for (int corner = 0; corner < 3; ++corner) {
        const double x = unit(random), y = height + slope * x + thickness * unit(random);
        const double distance = 2 + 40 * std::abs(unit(random));
        mesh.positions.push_back(glm::vec3(glm::dvec3(x, y, -1) * distance));
      }
      mesh.triangles = {{0, 1, 2}};
      SceneBuilder builder(size, size);
      builder.add(mesh, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
      builder.look({0, 0, 0}, {0, 0, -1}).project(Perspective{90, 1, 100});
      Scene& scene = builder.scene();
      scene.image.depth_format = format;
      const Judged judged = judge_scene(scene, 1);
      total.samples += judged.samples;
      total.outside += judged.outside;
    }
    EXPECT_GT(total.samples, 300u);
    EXPECT_EQ(total.outside, 0u) << name_of(format);
  }
}

}  // namespace
}  // namespace morphcl::test
