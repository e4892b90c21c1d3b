// The built-in sphere_to_cube: a closed sphere, a cube with whole edges, and every pose between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "morphcl/solids.hpp"
#include "tests/geometry/closed_surface.hpp"

namespace morphcl {
namespace {

using testing::WeldedSurface;

// A component is rounded to fp32 once, so a length is off by at most sqrt(3)/2 ulp of 1; 2^-23 covers it.
const double length_bound = std::ldexp(1.0, -23);

using Place = std::array<float, 3>;
Place place_of(const glm::vec3& p) { return {p.x, p.y, p.z}; }

class SphereToCube : public ::testing::TestWithParam<Segments> {
 protected:
  Mesh mesh = make_sphere_to_cube(GetParam());
  const MorphTarget& cube = mesh.targets[0];
  int around = (GetParam().u + 3) / 4, up = (GetParam().v + 1) / 2;

  std::vector<glm::vec3> pose(float weight) const {
    std::vector<glm::vec3> positions;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      positions.push_back((1 - weight) * mesh.positions[i] + weight * cube.positions[i]);
    return positions;
  }
};

TEST_P(SphereToCube, HasTheCountsThatItsSegmentsSay) {
  validate(mesh);
  EXPECT_EQ(mesh.positions.size(), 4u * (around + 1) * (up + 1) + 2u * (around + 1) * (around + 1));
  EXPECT_EQ(static_cast<long long>(mesh.positions.size()), sphere_to_cube_vertices(GetParam()));
  EXPECT_EQ(mesh.triangles.size(), 8u * around * up + 4u * around * around);
}

TEST_P(SphereToCube, IsClosedInEveryPose) {
  for (int step = 0; step <= 10; ++step) {
    const WeldedSurface surface = testing::weld(pose(0.1f * static_cast<float>(step)), mesh.triangles);
    EXPECT_EQ(surface.triangles.size(), mesh.triangles.size()) << "step " << step;
    EXPECT_TRUE(testing::is_closed(surface)) << "step " << step;
    EXPECT_EQ(testing::euler_characteristic(surface), 2) << "step " << step;
  }
}

// Seen from the centre, every triangle is wound counter-clockwise: the surface is a star around it, whatever the pose.
TEST_P(SphereToCube, FacesOutwardsInEveryPose) {
  for (int step = 0; step <= 10; ++step) {
    const std::vector<glm::vec3> positions = pose(0.1f * static_cast<float>(step));
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 a(positions[t.x]), b(positions[t.y]), c(positions[t.z]);
      ASSERT_GT(glm::dot(glm::cross(a, b), c), 0) << "step " << step << ", triangle " << (&t - mesh.triangles.data());
    }
  }
}

TEST_P(SphereToCube, LiesOnTheSphereWithItsNormals) {
  for (const glm::vec3& p : mesh.positions)
    ASSERT_NEAR(glm::length(glm::dvec3(p)), 1, length_bound) << "vertex " << (&p - mesh.positions.data());
  EXPECT_EQ(mesh.normals, mesh.positions);
}

TEST_P(SphereToCube, LiesInThePlanesOfTheCubeWithTheirNormals) {
  ASSERT_EQ(cube.form, TargetForm::absolute);
  ASSERT_EQ(cube.positions.size(), mesh.positions.size());
  ASSERT_EQ(cube.normals.size(), mesh.positions.size());
  for (std::size_t i = 0; i < cube.positions.size(); ++i) {
    const glm::vec3 p = cube.positions[i], n = cube.normals[i];
    ASSERT_EQ(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1) << "vertex " << i;
    ASSERT_EQ(glm::dot(p, n), 1) << "vertex " << i;
    ASSERT_EQ(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1) << "vertex " << i;
  }
  for (const glm::uvec3& t : mesh.triangles) {  // so that a face is of one colour up to its edges
    ASSERT_EQ(cube.normals[t.x], cube.normals[t.y]);
    ASSERT_EQ(cube.normals[t.x], cube.normals[t.z]);
  }
}

// A vertex goes straight away from the centre. Two roundings to fp32 of components up to 1 turn it by less than
// sqrt(3) 2^-24 each.
TEST_P(SphereToCube, MovesAwayFromTheCentre) {
  for (std::size_t i = 0; i < cube.positions.size(); ++i) {
    const glm::dvec3 on_sphere(mesh.positions[i]), on_cube(cube.positions[i]);
    ASSERT_LE(glm::length(glm::cross(on_sphere, on_cube)) / glm::length(on_cube), 2 * std::sqrt(3) * std::ldexp(1, -24))
        << "vertex " << i;
  }
}

TEST_P(SphereToCube, HasTheCubesCornersAndEdgesAsChainsOfItsOwn) {
  std::set<std::pair<Place, Place>> edges;
  for (const glm::uvec3& t : mesh.triangles)
    for (int corner = 0; corner < 3; ++corner)
      edges.emplace(place_of(cube.positions[t[corner]]), place_of(cube.positions[t[(corner + 1) % 3]]));
  for (int axis = 0; axis < 3; ++axis)
    for (const float s : {-1.0f, 1.0f})
      for (const float t : {-1.0f, 1.0f}) {
        const int next = (axis + 1) % 3, after = (axis + 2) % 3;
        std::set<float> along;
        for (const glm::vec3& p : cube.positions)
          if (p[next] == s && p[after] == t) along.insert(p[axis]);
        const int cells = axis == 1 ? up : around;
        ASSERT_EQ(along.size(), static_cast<std::size_t>(cells) + 1);
        EXPECT_EQ(*along.begin(), -1);
        EXPECT_EQ(*along.rbegin(), 1);
        Place from{}, to{};
        from[next] = to[next] = s;
        from[after] = to[after] = t;
        for (auto low = along.begin(), high = std::next(low); high != along.end(); ++low, ++high) {
          from[axis] = *low;
          to[axis] = *high;
          EXPECT_TRUE(edges.contains({from, to}) && edges.contains({to, from}))
              << "axis " << axis << " from " << *low << " to " << *high;
          EXPECT_TRUE(along.contains(-*low)) << "the cells of an edge are symmetric";
        }
      }
}

// A place is on one face, on an edge of two, or in a corner of three; each has its own normal on the cube and the same
// one on the sphere.
TEST_P(SphereToCube, HasOneVertexAPlaceAndFace) {
  std::map<Place, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < cube.positions.size(); ++i) places[place_of(cube.positions[i])].push_back(i);
  for (const auto& [place, vertices] : places) {
    const auto faces = std::count_if(place.begin(), place.end(), [](float c) { return std::abs(c) == 1; });
    ASSERT_EQ(vertices.size(), static_cast<std::size_t>(faces));
    std::set<Place> normals, on_sphere;
    for (const std::size_t vertex : vertices) {
      normals.insert(place_of(cube.normals[vertex]));
      on_sphere.insert(place_of(mesh.positions[vertex]));
    }
    EXPECT_EQ(normals.size(), vertices.size());
    EXPECT_EQ(on_sphere.size(), 1u);
  }
}

INSTANTIATE_TEST_SUITE_P(Segments, SphereToCube,
                         ::testing::Values(Segments{3, 2}, Segments{4, 2}, Segments{5, 3}, Segments{12, 6},
                                           Segments{16, 12}, Segments{28, 14}, Segments{64, 32}, Segments{4, 32},
                                           Segments{96, 2}),
                         [](const auto& test) {
                           return std::to_string(test.param.u) + "_" + std::to_string(test.param.v);
                         });

TEST(SphereToCubeSegments, AreRoundedUpToWholeCells) {
  EXPECT_EQ(make_sphere_to_cube({5, 3}).positions, make_sphere_to_cube({8, 4}).positions);
  EXPECT_NE(make_sphere_to_cube({8, 4}).positions, make_sphere_to_cube({9, 4}).positions);
}

// The step d = 90 degrees / n of a line on a face, seen from the centre, is d / sqrt(2) in the middle of an edge and d
// in the middle of the face, and between them elsewhere: with x = tan a, the speed (1 + x^2) sqrt(1 + y^2) /
// (1 + x^2 + y^2) is at least 1 / sqrt(2) (x = 0, y = 1) and at most 1. A chord of an arc s is at least s - s^3 / 24.
TEST(SphereToCubeCells, AreOfEvenSize) {
  for (const int n : {1, 2, 7, 16, 48}) {
    const Mesh mesh = make_sphere_to_cube({4 * n, 2 * n});
    const double step = std::numbers::pi / 2 / n, shortest = step / std::numbers::sqrt2;
    const double lower = shortest - shortest * shortest * shortest / 24 - 2 * length_bound;
    for (const glm::uvec3& t : mesh.triangles) {
      std::array<double, 3> sides{};
      for (int corner = 0; corner < 3; ++corner)
        sides[corner] =
            glm::length(glm::dvec3(mesh.positions[t[corner]]) - glm::dvec3(mesh.positions[t[(corner + 1) % 3]]));
      std::sort(sides.begin(), sides.end());
      ASSERT_GE(sides[0], lower) << "n " << n;
      ASSERT_LE(sides[1], step + 2 * length_bound) << "n " << n;
      ASSERT_LE(sides[2], step * std::numbers::sqrt2 + 2 * length_bound) << "n " << n;
    }
  }
}

// A point of a triangle with corners on the unit sphere, of weights x, y, z, has 1 - |p|^2 = xy c^2 + yz a^2 + zx b^2
// for the sides a, b, c; that is at most a third of the longest side's square, which is at most 2 steps^2.
TEST(SphereToCubeCells, StayNearTheSphere) {
  for (const int n : {1, 4, 16, 48}) {
    const Mesh mesh = make_sphere_to_cube({4 * n, 2 * n});
    const double step = std::numbers::pi / 2 / n, bound = 2 * step * step / 3 + 2 * length_bound;
    double largest = 0;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
      for (const glm::dvec3& p : {(a + b + c) / 3.0, (a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0})
        largest = std::max(largest, 1 - glm::dot(p, p));
    }
    EXPECT_LE(largest, bound) << "n " << n;
    RecordProperty("largest_of_bound_" + std::to_string(n), std::to_string(largest / bound));
  }
}

}  // namespace
}  // namespace morphcl
