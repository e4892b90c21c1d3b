// The built-in teapot against a model of the same teapot made by others. Its path: $MORPHCL_ASSETS/obj/teapot.obj.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "host/geometry/teapot_patches.hpp"
#include "tests/support/test_data.hpp"

namespace morphcl {
namespace {

// The model has 10 x 10 quads a patch and writes six decimals; it is y up, with the classic scale and height.
constexpr int model_segments = 10;
constexpr double half_of_the_last_decimal = 0.5e-6;

std::vector<glm::dvec3> model_vertices() {
  std::ifstream file(test_support::test_data("MORPHCL_ASSETS") / "obj/teapot.obj");
  std::vector<glm::dvec3> vertices;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    glm::dvec3 p;
    if (words >> kind >> p.x >> p.y >> p.z && kind == "v") vertices.emplace_back(p.x, -p.z, p.y);
  }
  return vertices;
}

std::vector<glm::dvec3> own_vertices() {
  std::vector<glm::dvec3> vertices;
  for (const BezierPatch& patch : teapot_patches())
    for (int i = 0; i <= model_segments; ++i)
      for (int j = 0; j <= model_segments; ++j)
        vertices.push_back(
            evaluate_patch(patch, static_cast<double>(i) / model_segments, static_cast<double>(j) / model_segments)
                .position);
  return vertices;
}

// Rounding a vertex to six decimals moves it by at most sqrt(3) half decimals; the model was computed in fp32, which
// adds as much again (ulp of 4 is 4.8e-7).
const double bound = 2 * std::sqrt(3.0) * half_of_the_last_decimal;

void expect_each_near_one(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& others,
                          const char* what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    double nearest = 1e9;
    for (const glm::dvec3& other : others) nearest = std::min(nearest, glm::length(points[i] - other));
    EXPECT_LE(nearest, bound) << what << " vertex " << i << " (" << points[i].x << ", " << points[i].y << ", "
                              << points[i].z << ")";
  }
}

TEST(TeapotModel, HasTheSameVertices) {
  const std::vector<glm::dvec3> model = model_vertices(), own = own_vertices();
  ASSERT_EQ(model.size(), 3644u);
  expect_each_near_one(model, own, "model");
  expect_each_near_one(own, model, "own");
}

}  // namespace
}  // namespace morphcl
