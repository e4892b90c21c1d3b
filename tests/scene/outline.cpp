#include "tests/scene/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "host/scene/model/elastic_object.hpp"
#include "morphcl/projection.hpp"

namespace morphcl::test {

namespace {

std::set<std::uint32_t> named_vertices(const Mesh& mesh, Shading shading) {
  std::set<std::uint32_t> vertices;
  if (shading == Shading::wireframe)
    for (const glm::uvec2& edge : wireframe_edges(mesh)) vertices.insert({edge.x, edge.y});
  else
    for (const glm::uvec3& triangle : mesh.triangles) vertices.insert({triangle.x, triangle.y, triangle.z});
  return vertices;
}

glm::dvec3 morphed(const Mesh& mesh, const std::vector<double>& weights, std::uint32_t vertex) {
  const glm::dvec3 base(mesh.positions[vertex]);
  glm::dvec3 point = base;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const MorphTarget& target = mesh.targets[i];
    if (target.positions.empty()) continue;
    const glm::dvec3 value(target.positions[vertex]);
    point += weights[i] * (target.form == TargetForm::absolute ? value - base : value);
  }
  return point;
}

}  // namespace

DrawnOutline drawn_outline(const Scene& scene) {
  const double aspect = static_cast<double>(scene.image.width) / scene.image.height;
  DrawnOutline outline;
  for (const Object& object : scene.objects) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    const std::set<std::uint32_t> vertices = named_vertices(mesh, object.material.shading);
    ElasticObject elastic;
    if (object.morph.elastic) elastic = make_elastic_object(mesh, object.morph, scene.timeline.time);
    Displacements displacements;
    for (const std::int64_t frame : frame_numbers(scene.frames)) {
      const FrameState state = evaluate(scene.timeline, frame);
      if (!state.node_visible[static_cast<std::size_t>(object.node)]) continue;
      const glm::dmat4 to_eye = state.camera.world_to_eye * state.node_to_world[static_cast<std::size_t>(object.node)];
      const glm::dmat4 to_clip = projection_matrix(state.camera.projection, aspect);
      const std::vector<double> weights = weights_at(object.morph, scene.timeline.time, frame);
      if (elastic.body) elastic.body->displacements_at(frame, displacements);
      for (const std::uint32_t vertex : vertices) {
        const glm::dvec3 point =
            elastic.body ? glm::dvec3(mesh.positions[vertex]) + displacements[elastic.mass_of_vertex[vertex]]
                         : morphed(mesh, weights, vertex);
        const glm::dvec4 eye = to_eye * glm::dvec4(point, 1), clip = to_clip * eye;
        const glm::dvec2 drawn = glm::dvec2(clip) / clip.w;
        outline.lower = glm::min(outline.lower, drawn);
        outline.upper = glm::max(outline.upper, drawn);
        outline.nearest = std::min(outline.nearest, -eye.z);
        outline.farthest = std::max(outline.farthest, -eye.z);
      }
    }
  }
  return outline;
}

DrawnOutline expect_fills(const Scene& scene) {
  // NDC spans 2. 1 % of the picture is what is promised; what is left of it is the rounding of a well placed scene.
  constexpr double part = 0.8, rounding = 1e-9;
  const DrawnOutline outline = drawn_outline(scene);
  const glm::dvec2 center = 0.5 * (outline.lower + outline.upper), size = 0.5 * (outline.upper - outline.lower);
  EXPECT_NEAR(center.x, 0, rounding);
  EXPECT_NEAR(center.y, 0, rounding);
  EXPECT_NEAR(std::max(size.x, size.y), part, rounding);
  const Projection& projection = scene.timeline.camera.projection;
  EXPECT_GT(outline.nearest, near_distance(projection));
  EXPECT_LT(outline.farthest, far_distance(projection));
  return outline;
}

}  // namespace morphcl::test
