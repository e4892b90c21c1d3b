// Vanishing points that a shot asks to be marked.
#include <gtest/gtest.h>

#include <cmath>

#include "morphcl/projection.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

Scene marked(const std::string& camera) {
  return ShotFolder().load("[camera]\nmark_vanishing_points = true\n" + camera + "\n" + std::string(test::cube_object));
}

glm::dvec2 ndc(const glm::dmat4& to_clip, const glm::dvec3& p) {
  const glm::dvec4 clip = to_clip * glm::dvec4(p, 1);
  return glm::dvec2(clip) / clip.w;
}

TEST(VanishingMarks, LinesLeadFromTheSolidToThePoint) {
  for (const char* camera :
       {"eye = [4, 3, 5]", "eye = [4, 3, 5]\nfar = inf\nfovx_degrees = 70",
        "projection = \"central\"\neye = [-3, 2, 6]\ntarget = [0, 2, 0]",
        "projection = \"frustum\"\neye = [1, 2, 6]\ntarget = [1, 2, 0]\nnear = 2\nfit = \"widen\""}) {
    SCOPED_TRACE(camera);
    const Scene scene = marked(camera);
    const CameraState view = evaluate(scene.timeline, 0).camera;
    const double aspect = 1920.0 / 1080;
    const glm::dmat4 to_clip = projection_matrix(view.projection, aspect) * view.world_to_eye;
    const VanishingPoints points = vanishing_points(view.projection, aspect, view.world_to_eye);
    ASSERT_EQ(static_cast<int>(scene.objects.size()), 1 + count(points));
    std::size_t at = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (!points[axis]) continue;
      const Object& object = scene.objects[at++];
      const Mesh& mesh = scene.meshes[object.mesh];
      EXPECT_EQ(object.name, std::string("vanishing point ") + "xyz"[axis]);
      EXPECT_EQ(object.material.shading, Shading::wireframe);
      ASSERT_EQ(mesh.edges.size(), 6u);
      for (int line = 0; line < 4; ++line) {
        const glm::dvec3 corner = mesh.positions[mesh.edges[line].x], end = mesh.positions[mesh.edges[line].y];
        // Bounds are wider than the mesh by what rounding may do to it.
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::abs(corner[i]), 1, 1e-6);
        // Positions of at most 100 in fp32, at a distance of 4 at least: 100 * 2^-24 * 2.
        const glm::dvec2 image = ndc(to_clip, end);
        EXPECT_NEAR(image.x, points[axis]->x, 2e-5);
        EXPECT_NEAR(image.y, points[axis]->y, 2e-5);
        EXPECT_GT(-(view.world_to_eye * glm::dvec4(end, 1)).z, near_distance(view.projection));
        // The edge of the cube lies on the line's image, on the way to its end.
        glm::dvec3 other = corner;
        other[axis] = -other[axis];
        const glm::dvec2 along = image - ndc(to_clip, corner), edge = ndc(to_clip, other) - ndc(to_clip, corner);
        EXPECT_NEAR(along.x * edge.y - along.y * edge.x, 0, 2e-5 * glm::length(edge));
        EXPECT_GT(glm::dot(along, edge), 0);
      }
    }
  }
}

TEST(VanishingMarks, AreNotThereUnlessAskedFor) {
  EXPECT_EQ(ShotFolder().load("[camera]\neye = [4, 3, 5]\n" + std::string(test::cube_object)).objects.size(), 1u);
  EXPECT_EQ(ShotFolder()
                .load("[camera]\nmark_vanishing_points = false\nprojection = \"isometric\"\n" +
                      std::string(test::cube_object))
                .objects.size(),
            1u);
}

TEST(VanishingMarks, AreRefusedWhereThereAreNone) {
  const ShotFolder folder;
  EXPECT_EQ(folder.refusal("[camera]\nprojection = \"isometric\"\nmark_vanishing_points = true\n" +
                           std::string(test::cube_object)),
            "shot.toml:3:25: a parallel projection has no vanishing points");
  EXPECT_EQ(
      folder.refusal("[camera]\nmark_vanishing_points = true\n[[camera.track]]\ntarget = \"eye\"\nkeys = [[0, [1, "
                     "2, 3]]]\n" +
                     std::string(test::cube_object)),
      "shot.toml:2:25: vanishing points can be marked for a camera that stands still; this one has tracks");
}

}  // namespace
}  // namespace morphcl
