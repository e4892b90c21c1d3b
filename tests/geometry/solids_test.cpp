#include "morphcl/solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/geometry/bounds.hpp"
#include "morphcl/error.hpp"
#include "tests/geometry/closed_surface.hpp"

namespace morphcl {
namespace {

using testing::WeldedSurface;

// A unit vector's components are rounded to fp32 once: each is off by at most half an ulp of 1, the length by sqrt(3)
// times that; 2^-23 covers it.
const double unit_length_bound = std::ldexp(1.0, -23);

struct Closed {
  const char* name;
  std::optional<Segments> segments;
  int euler;
};
void PrintTo(const Closed& solid, std::ostream* out) { *out << solid.name; }

class ClosedSolid : public ::testing::TestWithParam<Closed> {
 protected:
  Mesh mesh = make_solid(GetParam().name, GetParam().segments);
};

TEST_P(ClosedSolid, HasEveryEdgeOnceInEachDirection) {
  EXPECT_TRUE(testing::is_closed(testing::weld(mesh.positions, mesh.triangles)));
}

TEST_P(ClosedSolid, HasItsEulerCharacteristic) {
  EXPECT_EQ(testing::euler_characteristic(testing::weld(mesh.positions, mesh.triangles)), GetParam().euler);
}

TEST_P(ClosedSolid, IsWoundOutwards) {
  EXPECT_GT(testing::signed_volume(testing::weld(mesh.positions, mesh.triangles)), 0);
  for (const MorphTarget& target : mesh.targets)
    EXPECT_GT(testing::signed_volume(testing::weld(target.positions, mesh.triangles)), 0) << target.name;
}

TEST_P(ClosedSolid, HasUnitNormalsOnTheOutside) {
  validate(mesh);
  for (const glm::vec3& normal : mesh.normals)
    ASSERT_NEAR(glm::length(glm::dvec3(normal)), 1, unit_length_bound) << "normal " << (&normal - mesh.normals.data());
  if (mesh.normals.empty()) return;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    if (glm::length(area) < 1e-12) continue;  // a triangle at a pole
    for (int corner = 0; corner < 3; ++corner)
      ASSERT_GT(glm::dot(area, glm::dvec3(mesh.normals[t[corner]])), 0) << "triangle " << (&t - mesh.triangles.data());
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ClosedSolid,
    ::testing::Values(Closed{"pyramid_to_cube", {}, 2}, Closed{"cube", {}, 2}, Closed{"sphere", {}, 2},
                      Closed{"sphere", Segments{3, 2}, 2}, Closed{"sphere", Segments{7, 5}, 2},
                      Closed{"sphere_to_cube", {}, 2}, Closed{"sphere_to_cube", Segments{8, 6}, 2},
                      Closed{"torus", {}, 0}, Closed{"torus", Segments{5, 7}, 0}, Closed{"cylinder", {}, 2},
                      Closed{"cylinder", Segments{3, 4}, 2}, Closed{"cone", {}, 2}, Closed{"cone", Segments{5, 3}, 2},
                      Closed{"prism", {}, 2}, Closed{"prism", Segments{3, 2}, 2}),
    [](const auto& test) { return std::string(test.param.name) + "_" + std::to_string(test.index); });

Mesh morphed(const Mesh& mesh, float weight) {
  Mesh result = mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    result.positions[i] = (1 - weight) * mesh.positions[i] + weight * mesh.targets[0].positions[i];
  return result;
}

TEST(PyramidToCube, IsClosedAndOutwardAtEveryStep) {
  const Mesh mesh = make_pyramid_to_cube();
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.edges.size(), 12u);
  double before = 0;
  for (int step = 0; step <= 100; ++step) {
    const Mesh now = morphed(mesh, static_cast<float>(step) / 100);
    const WeldedSurface surface = testing::weld(now.positions, now.triangles);
    EXPECT_TRUE(testing::is_closed(surface)) << "step " << step;
    EXPECT_EQ(testing::euler_characteristic(surface), 2) << "step " << step;
    const double volume = testing::signed_volume(surface);
    EXPECT_GT(volume, before) << "step " << step;
    before = volume;
  }
}

TEST(PyramidToCube, HasTheClassicNumbers) {
  const Mesh mesh = make_pyramid_to_cube();
  EXPECT_NEAR(testing::signed_volume(testing::weld(mesh.positions, mesh.triangles)), 100. * 100 * 70 / 3, 1e-6);
  EXPECT_NEAR(testing::signed_volume(testing::weld(mesh.targets[0].positions, mesh.triangles)), 100. * 100 * 70, 1e-6);
  const Mesh step_37 = morphed(mesh, 0.37f);
  const float bound = 100 * std::ldexp(1.0f, -23);  // two products and a sum of numbers up to 150
  const std::vector<glm::vec3> top = {{81.5, 81.5, 100}, {118.5, 81.5, 100}, {118.5, 118.5, 100}, {81.5, 118.5, 100}};
  for (std::size_t i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(step_37.positions[4 + i][c], top[i][c], 2 * bound) << "top corner " << i << ", component " << c;
}

TEST(PyramidToCube, DrawsTheTwelveEdgesOfTheBox) {
  const Mesh mesh = make_pyramid_to_cube();
  for (const glm::uvec2& edge : mesh.edges) {
    const glm::vec3 along = glm::abs(mesh.targets[0].positions[edge.x] - mesh.targets[0].positions[edge.y]);
    EXPECT_EQ((along.x != 0) + (along.y != 0) + (along.z != 0), 1) << edge.x << "-" << edge.y;
  }
  EXPECT_EQ(distinct_edges(mesh.triangles).size(), 18u) << "twelve, and a diagonal for each of the six faces";
}

TEST(Cube, DrawsTwelveEdges) {
  const Mesh mesh = make_cube();
  EXPECT_EQ(mesh.positions.size(), 24u);
  std::map<std::array<float, 3>, int> middles;
  for (const glm::uvec2& edge : mesh.edges) {
    const glm::vec3 middle = mesh.positions[edge.x] + mesh.positions[edge.y];
    ++middles[{middle.x, middle.y, middle.z}];
    EXPECT_EQ(glm::length(mesh.positions[edge.x] - mesh.positions[edge.y]), 2);
  }
  EXPECT_EQ(middles.size(), 12u);
}

TEST(Sphere, HasExactPolesSeamAndRadius) {
  const Mesh mesh = make_sphere({8, 4});
  EXPECT_EQ(mesh.positions.size(), 45u);
  EXPECT_EQ(mesh.triangles.size(), 2u * 8 * 3);
  EXPECT_EQ(mesh.positions[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.positions[44], glm::vec3(0, -1, 0));
  EXPECT_EQ(mesh.positions[2 * 9 + 2], glm::vec3(1, 0, 0));  // a quarter around on the equator
  for (int j = 0; j <= 4; ++j) EXPECT_EQ(mesh.positions[9 * j], mesh.positions[9 * j + 8]) << "seam, row " << j;
  EXPECT_EQ(mesh.positions, mesh.normals);
}

TEST(Grid, LiesInThePlaneAndFacesUp) {
  const Mesh mesh = make_grid({3, 2});
  EXPECT_EQ(mesh.positions.size(), 12u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  const Box box = box_of(mesh.positions);
  EXPECT_EQ(box.lower, glm::dvec3(-1, 0, -1));
  EXPECT_EQ(box.upper, glm::dvec3(1, 0, 1));
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 cross =
        glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
    EXPECT_GT(cross.y, 0);
    area += cross.y / 2;
  }
  EXPECT_NEAR(area, 4, 1e-6);
}

TEST(Torus, IsWithinItsRadii) {
  for (const glm::vec3& p : make_torus({16, 8}).positions) {
    const double from_ring = std::hypot(std::hypot(p.x, p.z) - 0.7, static_cast<double>(p.y));
    EXPECT_NEAR(from_ring, 0.3, 2 * unit_length_bound);
  }
}

TEST(Cylinder, ConeAndCylinderHaveTheSameTopology) {
  const Mesh cylinder = make_cylinder({7, 2}), cone = make_cone({7, 2});
  EXPECT_EQ(cylinder.triangles, cone.triangles);
  EXPECT_EQ(cylinder.positions.size(), cone.positions.size());
  EXPECT_EQ(cylinder.positions.size(), 8u * 7);
  EXPECT_EQ(cylinder.triangles.size(), 2u * 7 * 3);
}

// A regular polygon of u corners at radius 1 has the area u sin(360 / u) / 2; the rest follows. 2^-22 of the volume:
// each coordinate is off by half an ulp of fp32 at most, and the volume by three times as much in proportion.
TEST(Cylinder, VolumesAreThoseOfThePolygonsOnTheirCircle) {
  constexpr double pi = 3.14159265358979323846, bound = 0x1p-22;
  const auto volume = [](const Mesh& mesh) {
    return testing::signed_volume(testing::weld(mesh.positions, mesh.triangles));
  };
  for (const int u : {3, 4, 6, 17}) {
    const double area = 0.5 * u * std::sin(2 * pi / u);
    EXPECT_NEAR(volume(make_cylinder({u, 3})) / (2 * area), 1, bound) << u;
    EXPECT_NEAR(volume(make_cone({u, 3})) / (2 * area / 3), 1, bound) << u;
    EXPECT_NEAR(volume(make_prism({u, 3})) / (2 * area), 1, bound) << u;
    const std::vector<glm::dvec2> profile = {{0, 3}, {2, 0}, {1, -3}, {0, -3}};
    const double cones = area * (4 * 3 / 3.0 + (4 + 2 + 1) * 3 / 3.0);  // a cone and a frustum
    EXPECT_NEAR(volume(make_revolution(profile, u)) / cones, 1, bound) << u;
  }
}

TEST(Prism, DrawsItsOwnEdges) {
  const Mesh mesh = make_prism({6, 1});
  EXPECT_EQ(mesh.edges.size(), 18u);
  for (const glm::uvec2& edge : mesh.edges) {
    const glm::dvec3 along = glm::dvec3(mesh.positions[edge.x]) - glm::dvec3(mesh.positions[edge.y]);
    // As long as the radius, or as high as the prism.
    EXPECT_NEAR(glm::length(along), along.y == 0 ? 1 : 2, 4 * unit_length_bound);
  }
}

TEST(Revolution, ClosedProfilesAreClosedSurfaces) {
  const std::vector<glm::dvec2> top = {{0, 1}, {1, 0.5}, {1, -0.5}, {0, -1}}, ring = {{2, 1}, {3, 0}, {2, -1}, {2, 1}},
                                open = {{1, 1}, {1, -1}};
  const auto surface = [](const std::vector<glm::dvec2>& profile) {
    const Mesh mesh = make_revolution(profile, 9);
    validate(mesh);
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(glm::dvec3(normal)), 1, unit_length_bound);
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
      for (int corner = 0; corner < 3; ++corner)
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), glm::dvec3(mesh.normals[t[corner]])), 0);
    }
    return testing::weld(mesh.positions, mesh.triangles);
  };
  EXPECT_TRUE(testing::is_closed(surface(top)));
  EXPECT_EQ(testing::euler_characteristic(surface(top)), 2);
  EXPECT_TRUE(testing::is_closed(surface(ring)));
  EXPECT_EQ(testing::euler_characteristic(surface(ring)), 0);
  EXPECT_FALSE(testing::is_closed(surface(open)));
}

TEST(Revolution, PiecesOnTheAxisAndWithoutLengthHaveNoBand) {
  const std::vector<glm::dvec2> profile = {{0, 2}, {0, 1}, {1, 0}, {1, 0}, {0, -1}};
  EXPECT_EQ(make_revolution(profile, 5).positions.size(), 2u * 2 * 6);
}

TEST(Curve, GoesThroughItsPointsAndKeepsLines) {
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 2, 0}, {3, 1, 5}, {4, 4, 4}};
  const Mesh mesh = make_curve(points, 8);
  validate(mesh);
  ASSERT_EQ(mesh.positions.size(), 25u);
  EXPECT_EQ(mesh.edges.size(), 24u);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(mesh.positions[8 * i], glm::vec3(points[i])) << i;
  // Halfway, Catmull and Rom: (9 (b + c) - a - d) / 16.
  EXPECT_EQ(mesh.positions[12], glm::vec3((9.0 * (points[1] + points[2]) - points[0] - points[3]) / 16.0));
  const std::vector<glm::dvec3> line = {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
  for (const glm::vec3& p : make_curve(line, 4).positions) EXPECT_EQ(p, p.x * glm::vec3(1, 2, 3));
}

TEST(Curve, RefusesWhatCannotBeMade) {
  const auto message = [](auto&& make) -> std::string {
    try {
      make();
    } catch (const Error& error) {
      return error.message();
    }
    return "accepted";
  };
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 0, 0}}, not_a_number = {{0, 0, 0}, {NAN, 0, 0}};
  EXPECT_EQ(message([&] { make_curve(not_a_number, 1); }), "point 1 of the curve is not finite");
  EXPECT_EQ(message([&] { make_curve(points, 0); }), "0 edges from point to point; 1 or more are needed");
  EXPECT_EQ(message([&] { make_curve(points, 1 << 27); }),
            "134217728 edges between 2 points make more than the 134217728 vertices that are allowed");
  const std::vector<glm::dvec2> profile = {{1, 0}, {1, 1}}, unbounded = {{1, 0}, {INFINITY, 1}};
  EXPECT_EQ(message([&] { make_revolution(unbounded, 5); }), "point 1 of the profile is not finite");
  EXPECT_EQ(message([&] { make_revolution(profile, 1 << 27); }),
            "1 bands of 134217728 pieces make more than the 134217728 vertices that are allowed");
}

std::string refusal(const char* name, std::optional<Segments> segments) {
  try {
    make_solid(name, segments);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.message();
  }
  return "accepted";
}

TEST(MakeSolid, RefusesWhatCannotBeMade) {
  EXPECT_EQ(refusal("spheer", {}), "there is no built-in solid \"spheer\"");
  EXPECT_EQ(refusal("cube", Segments{4, 4}), "the solid \"cube\" takes no segments");
  EXPECT_EQ(refusal("sphere", Segments{2, 2}), "segments [2, 2] are too few; \"sphere\" needs at least [3, 2]");
  EXPECT_EQ(refusal("sphere", Segments{3, 1}), "segments [3, 1] are too few; \"sphere\" needs at least [3, 2]");
  EXPECT_EQ(refusal("sphere_to_cube", Segments{2, 2}),
            "segments [2, 2] are too few; \"sphere_to_cube\" needs at least [3, 2]");
  EXPECT_EQ(refusal("grid", Segments{-5, 1}), "segments [-5, 1] are too few; \"grid\" needs at least [1, 1]");
}

TEST(MakeSolid, RefusesMoreThanItsVerticesBeforeMakingThem) {
  const char* message = " make more than the 134217728 vertices that are allowed";
  EXPECT_EQ(refusal("sphere", Segments{2147483647, 2147483647}),
            std::string("segments [2147483647, 2147483647]") + message);
  EXPECT_EQ(refusal("grid", Segments{16384, 8191}), std::string("segments [16384, 8191]") + message);
  EXPECT_EQ(solid_vertices("grid", Segments{16383, 8191}), max_solid_vertices);
  EXPECT_EQ(refusal("sphere_to_cube", Segments{16384, 16384}), std::string("segments [16384, 16384]") + message);
  EXPECT_EQ(refusal("sphere_to_cube", Segments{134217727, 134217727}),
            std::string("segments [134217727, 134217727]") + message);
  EXPECT_EQ(refusal("teapot", Segments{2048, 2048}), std::string("segments [2048, 2048]") + message);
}

TEST(MakeSolid, CountsItsVertices) {
  for (const SolidInfo& solid : solids())
    EXPECT_EQ(solid_vertices(solid.name), static_cast<long long>(make_solid(solid.name).positions.size()))
        << solid.name;
}

}  // namespace
}  // namespace morphcl
