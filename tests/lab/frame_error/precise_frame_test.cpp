// The high-precision render against formulas for planes: rays of the pixels' centres, lights, colours, coverage.
#include "lab/frame_error/precise_frame.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tests/render/scene_builder.hpp"

namespace morphcl::accuracy {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;  // 113 bits
using test::SceneBuilder;

constexpr int plane_width = 64, plane_height = 36;
const Quad tiny = ldexp(Quad(1), -100);  // some roundings of 2^-113, amplified by the slant of the planes

// A large triangle through `at` that faces the camera at the origin, looking down -z; colours grow along x and y.
Mesh slanted_plane() {
  Mesh mesh;
  mesh.positions = {{-40, -20, -3}, {40, -20, -6}, {0, 40, -12}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

Scene plane_scene(const Projection& projection, Shading shading) {
  SceneBuilder b(plane_width, plane_height);
  b.add(slanted_plane(), shading, glm::dmat4(1), {1, 0.5, 0.25, 1});
  b.no_lights().point_light({0.5, 1, -1}, {2, 3, 4}, true).scene().timeline.ambient = {0.125, 0.125, 0.125};
  return b.look({0, 0, 0}, {0, 0, -1}).project(projection).scene();
}

struct Ray {
  Vector3<Quad> start, direction;  // direction.z is -1
};

Ray ray_of(const Projection& projection, int x, int y) {
  const Quad across = Quad(2 * x + 1) / plane_width - 1, up = 1 - Quad(2 * y + 1) / plane_height;
  const glm::dmat4 m = projection_matrix(projection, double(plane_width) / plane_height);
  if (std::holds_alternative<Orthographic>(projection))
    return {{(across - Quad(m[3][0])) / Quad(m[0][0]), (up - Quad(m[3][1])) / Quad(m[1][1]), 0}, {0, 0, -1}};
  return {{0, 0, 0}, {(across + Quad(m[2][0])) / Quad(m[0][0]), (up + Quad(m[2][1])) / Quad(m[1][1]), -1}};
}

struct Point {
  Vector3<Quad> position, weight;
};

// Where a ray meets the plane, and that point's barycentric coordinates in space.
Point meet(const Ray& ray) {
  const Mesh mesh = slanted_plane();
  const auto a = to_real<Quad>(mesh.positions[0]), b = to_real<Quad>(mesh.positions[1]),
             c = to_real<Quad>(mesh.positions[2]);
  const auto normal = cross(b - a, c - a);
  const Quad t = dot(normal, a - ray.start) / dot(normal, ray.direction);
  const Vector3<Quad> p = ray.start + ray.direction * t;
  const auto share = [&](const Vector3<Quad>& from, const Vector3<Quad>& to) -> Quad {
    return dot(normal, cross(to - from, p - from)) / dot(normal, normal);
  };
  return {p, {share(b, c), share(c, a), share(a, b)}};
}

const Projection projections[] = {Perspective{60, 0.1, 1000}, Frustum{-0.1, 0.3, -0.05, 0.1, 0.2, 1000},
                                  Orthographic{-2, 3, -1, 2, -1, 1000}};

TEST(PreciseFrame, PlanesLieWhereTheRaysMeetThem) {
  for (const Projection& projection : projections) {
    const Scene scene = plane_scene(projection, Shading::unlit);
    const PreciseFrame<TrueGeometry<Quad>> frame(scene, 0);
    const auto visible = frame.find_visible();
    int covered = 0;
    for (int y = 0; y < plane_height; ++y)
      for (int x = 0; x < plane_width; ++x) {
        const Point truth = meet(ray_of(projection, x, y));
        const bool inside = truth.weight.x > 0 && truth.weight.y > 0 && truth.weight.z > 0;
        const Visible<Quad>& shown = visible[static_cast<std::size_t>(y) * plane_width + x];
        ASSERT_EQ(shown.object, inside ? 0u : no_object) << x << ", " << y;
        if (!inside) continue;
        ++covered;
        ASSERT_LE(abs(shown.distance + truth.position.z), tiny * abs(truth.position.z)) << x << ", " << y;
      }
    EXPECT_GT(covered, plane_width * plane_height / 2);
  }
}

// Ambient light 1/8, a point light with falloff, and colours that are interpolated in perspective.
TEST(PreciseFrame, LitAndColoredAsTheFormulaSays) {
  for (const Projection& projection : projections) {
    const Scene scene = plane_scene(projection, Shading::smooth);
    const PreciseFrame<TrueGeometry<Quad>> frame(scene, 0);
    for (int y = 0; y < plane_height; y += 5)
      for (int x = 0; x < plane_width; x += 5) {
        const auto hit = frame.hit(0, 0, x, y);
        if (!hit) continue;
        const Point truth = meet(ray_of(projection, x, y));
        const Vector3<Quad> to_light = Vector3<Quad>{Quad(0.5), Quad(1), Quad(-1)} - truth.position;
        const Quad square = dot(to_light, to_light);
        const Quad cosine = to_light.z / sqrt(square);  // the normals are 0 0 1
        const Quad lit = cosine > 0 ? Quad(cosine / square) : Quad(0);
        const Quad expected[3] = {(Quad(0.125) + 2 * lit) * truth.weight.y,
                                  Quad(0.5) * (Quad(0.125) + 3 * lit) * truth.weight.z, 0};
        const Vector3<Quad> color = frame.color(0, 0, *hit, x, y);
        ASSERT_LE(abs(color.x - expected[0]), tiny);
        ASSERT_LE(abs(color.y - expected[1]), tiny);
        ASSERT_EQ(color.z, 0);
      }
  }
}

TEST(PreciseFrame, ClippingLeavesWhatLiesBetweenNearAndFar) {
  const Projection projection = Perspective{60, 4, 7};
  const Scene scene = plane_scene(projection, Shading::unlit);
  const PreciseFrame<TrueGeometry<Quad>> frame(scene, 0);
  const auto visible = frame.find_visible();
  int covered = 0;
  for (int y = 0; y < plane_height; ++y)
    for (int x = 0; x < plane_width; ++x) {
      const Point truth = meet(ray_of(projection, x, y));
      const Quad distance = -truth.position.z;
      const bool inside =
          truth.weight.x > 0 && truth.weight.y > 0 && truth.weight.z > 0 && distance > 4 && distance < 7;
      ASSERT_EQ(visible[static_cast<std::size_t>(y) * plane_width + x].object, inside ? 0u : no_object)
          << x << ", " << y;
      covered += inside;
    }
  EXPECT_GT(covered, 100);
}

// Corners on pixel centres and on whole sub-pixels: two triangles that share their diagonal cover the square half-open.
template <class Geometry>
void expect_square(const Geometry&) {
  SceneBuilder b(plane_width, plane_height);
  Mesh square;
  square.positions = {{8.5f, 4.5f, -1}, {24.5f, 4.5f, -1}, {24.5f, 20.5f, -1}, {8.5f, 20.5f, -1}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  b.add(square, Shading::unlit, glm::dmat4(1), {1, 1, 1, 1}, true);
  b.look({0, 0, 0}, {0, 0, -1}).project(Orthographic{0, plane_width, 0, plane_height, 0, 2});
  const PreciseFrame<Geometry> frame(b.scene(), 0);
  const auto visible = frame.find_visible();
  for (int y = 0; y < plane_height; ++y)
    for (int x = 0; x < plane_width; ++x) {
      // Rows count from the top: the centre of row y lies at height - 0.5 - y. Top and left edges own their centres.
      const bool inside = x >= 8 && x < 24 && y >= plane_height - 21 && y < plane_height - 5;
      EXPECT_EQ(visible[static_cast<std::size_t>(y) * plane_width + x].object, inside ? 0u : no_object)
          << x << ", " << y;
    }
}

TEST(PreciseFrame, EdgesBelongToTheTopAndLeft) {
  expect_square(OnGrid<double>());
  expect_square(TrueGeometry<double>());
  expect_square(OnGrid<Quad>());
}

TEST(PreciseFrame, LinesTakeOnePixelAColumn) {
  SceneBuilder b(plane_width, plane_height);
  Mesh line;
  line.positions = {{2.5f, 3.5f, -1}, {42.5f, 13.5f, -1}};
  line.edges = {{0, 1}};
  b.add(line, Shading::wireframe);
  b.look({0, 0, 0}, {0, 0, -1}).project(Orthographic{0, plane_width, 0, plane_height, 0, 2});
  const PreciseFrame<OnGrid<double>> frame(b.scene(), 0);
  const auto visible = frame.find_visible();
  for (int x = 0; x < plane_width; ++x) {
    int shown = 0, row = -1;
    for (int y = 0; y < plane_height; ++y)
      if (visible[static_cast<std::size_t>(y) * plane_width + x].object != no_object) {
        ++shown;
        row = y;
      }
    ASSERT_EQ(shown, x >= 2 && x < 42 ? 1 : 0) << "column " << x;
    // At x + 0.5 the line is 3.5 + (x - 2) / 4 above the lower edge.
    if (shown != 1) continue;
    EXPECT_EQ(row, static_cast<int>(std::floor(plane_height - 3.5 - (x - 2) / 4.0))) << "column " << x;
  }
}

}  // namespace
}  // namespace morphcl::accuracy
