// Real .obj files, read a second time by tinyobjloader, below the folder that MORPHCL_ASSETS names.
#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "host/scene/obj/obj_import.hpp"
#include "morphcl/mesh.hpp"
#include "tests/support/test_data.hpp"

namespace morphcl::test {
namespace {

std::string asset(const std::string& name) { return test_support::test_data("MORPHCL_ASSETS") / name; }

// No values, and so no tests, without the assets.
std::vector<std::string> if_present(std::vector<std::string> names) {
  return std::getenv("MORPHCL_ASSETS") ? std::move(names) : std::vector<std::string>{};
}

// tinyobjloader builds decimals step by step in fp64, off by some 1e-15, and rounds again: at most one fp32 step away.
void expect_within_one_step(const glm::vec3& actual, const float* expected, std::size_t triangle) {
  for (int axis = 0; axis < 3; ++axis) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_GE(actual[axis], std::nextafter(expected[axis], -infinity)) << "triangle " << triangle << ", axis " << axis;
    EXPECT_LE(actual[axis], std::nextafter(expected[axis], infinity)) << "triangle " << triangle << ", axis " << axis;
  }
}

class RealObj : public testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealObj);

// For each face of a file: the number of its material in the order of their first faces.
std::vector<std::size_t> materials_of_faces(const std::string& path) {
  std::vector<std::size_t> materials;
  std::map<std::string, std::size_t> numbers;
  std::ifstream file(path);
  std::string line, material;
  while (std::getline(file, line)) {
    if (line.starts_with("usemtl ")) material = line;
    if (line.starts_with("f ")) materials.push_back(numbers.try_emplace(material, numbers.size()).first->second);
  }
  return materials;
}

TEST_P(RealObj, HasTheFacesThatTinyobjloaderSees) {
  const std::string path = asset(GetParam());
  const ImportedModel model = import_obj(path);
  for (const Mesh& mesh : model.meshes) EXPECT_NO_THROW(validate(mesh));

  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  tinyobj::ObjReader reader;
  ASSERT_TRUE(reader.ParseFromFile(path, config)) << reader.Error();
  const std::vector<float>& positions = reader.GetAttrib().vertices;
  const std::vector<std::size_t> materials = materials_of_faces(path);
  std::vector<std::size_t> triangle(model.meshes.size());  // how many were compared
  std::vector<std::set<std::pair<int, int>>> sides(model.meshes.size());
  std::size_t face = 0;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    std::size_t first = 0;
    for (const unsigned int corners : shape.mesh.num_face_vertices) {
      ASSERT_LT(face, materials.size());
      const std::size_t part = materials[face++];
      ASSERT_LT(part, model.meshes.size());
      const Mesh& mesh = model.meshes[part];
      // The corners of a face's triangles, whichever way it was cut, are the corners of the face.
      std::set<int> expected, actual_corners;
      for (std::size_t c = 0; c < corners; ++c) {
        const int a = shape.mesh.indices[first + c].vertex_index;
        const int b = shape.mesh.indices[first + (c + 1) % corners].vertex_index;
        expected.insert(a);
        sides[part].emplace(std::min(a, b), std::max(a, b));
      }
      const std::size_t triangles = std::size_t{corners} - 2;
      ASSERT_LE(triangle[part] + triangles, mesh.triangles.size());
      for (std::size_t t = 0; t < triangles; ++t) {
        for (int c = 0; c < 3; ++c) {
          const glm::vec3& p = mesh.positions[mesh.triangles[triangle[part]][c]];
          int nearest = -1;
          float best = std::numeric_limits<float>::infinity();
          for (const int candidate : expected) {
            const float* q = &positions[3 * static_cast<std::size_t>(candidate)];
            const float distance = glm::distance(p, glm::vec3(q[0], q[1], q[2]));
            if (distance < best) {
              best = distance;
              nearest = candidate;
            }
          }
          ASSERT_GE(nearest, 0);
          actual_corners.insert(nearest);
          expect_within_one_step(p, &positions[3 * static_cast<std::size_t>(nearest)], triangle[part]);
        }
        ++triangle[part];
      }
      EXPECT_EQ(actual_corners.size(), expected.size()) << "before triangle " << triangle[part];
      first += corners;
    }
  }
  EXPECT_EQ(face, materials.size());
  for (std::size_t part = 0; part < model.meshes.size(); ++part) {
    EXPECT_EQ(triangle[part], model.meshes[part].triangles.size());
    EXPECT_EQ(wireframe_edges(model.meshes[part]).size(), sides[part].size());
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, RealObj,
                         testing::ValuesIn(if_present({"obj/spot.obj", "obj/suzanne.obj",
                                                       "obj_face/generic_neutral_mesh.obj"})));

class RealFace : public testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealFace);

TEST_P(RealFace, ExpressionsFitTheNeutralFace) {
  const ImportedModel model =
      import_obj_targets(asset(GetParam()), {asset("obj_face/jawOpen.obj"), asset("obj_face/browInnerUp_L.obj")});
  // As many as the file has of position, normal and texture coordinates together, by the values of these, in each
  // material: counted by a few lines of Python. Pairs of position and normal are 26719.
  std::size_t vertices = 0;
  std::map<std::string, std::size_t> moved;
  for (const Mesh& mesh : model.meshes) {
    vertices += mesh.positions.size();
    ASSERT_EQ(mesh.targets.size(), 2u);
    EXPECT_EQ(mesh.targets[0].name, "jawOpen");
    for (const MorphTarget& target : mesh.targets)
      for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        moved[target.name] += target.positions[i] != mesh.positions[i];
  }
  EXPECT_EQ(vertices, 28716u);
  for (const auto& [target, count] : moved) {
    EXPECT_GT(count, 100u) << target;
    EXPECT_LT(count, vertices) << target;
  }
}

INSTANTIATE_TEST_SUITE_P(Assets, RealFace, testing::ValuesIn(if_present({"obj_face/generic_neutral_mesh.obj"})));

}  // namespace
}  // namespace morphcl::test
