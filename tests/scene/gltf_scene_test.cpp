// What is around the meshes of a glTF file: nodes, scenes, cameras, lights, and what is said to be left out.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/scene/gltf/gltf_import.hpp"
#include "tests/scene/gltf_builder.hpp"

namespace morphcl::test {
namespace {

class GltfScene : public testing::Test {
 protected:
  ImportedModel import(const GltfBuilder& file) { return import_gltf(file.write(folder), TimeBase{}); }
  test_support::TemporaryFolder folder;
};

TEST_F(GltfScene, NodesKeepTranslationRotationScaleAndParents) {
  GltfBuilder file = triangle_file();
  file.json["nodes"][0]["scale"] = {-1, 2, 3};
  file.node({{"name", "top"}, {"children", {0}}, {"translation", {1, 2, 3}}, {"rotation", {0, 0.6, 0, 0.8}}});
  const ImportedModel model = import(file);
  ASSERT_EQ(model.nodes.size(), 2u);
  EXPECT_EQ(model.nodes[0].name, "node0");
  EXPECT_EQ(model.nodes[0].parent, 1);
  EXPECT_EQ(model.nodes[0].scale, glm::dvec3(-1, 2, 3));
  EXPECT_EQ(model.nodes[1].name, "top");
  EXPECT_EQ(model.nodes[1].parent, -1);
  EXPECT_EQ(model.nodes[1].translation, glm::dvec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(model.nodes[1].rotation.y, 0.6);
  EXPECT_DOUBLE_EQ(model.nodes[1].rotation.w, 0.8);
}

TEST_F(GltfScene, MatrixNodeColumnByColumn) {
  GltfBuilder file = triangle_file();
  file.json["nodes"][0]["matrix"] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 1};
  const glm::dmat4 matrix = import(file).nodes[0].static_transform;
  EXPECT_EQ(matrix[0], glm::dvec4(1, 2, 3, 0));
  EXPECT_EQ(matrix[3], glm::dvec4(10, 11, 12, 1));
}

TEST_F(GltfScene, RotationsAreScaledToUnitLengthWithAWarning) {
  GltfBuilder file = triangle_file();
  file.json["nodes"][0]["rotation"] = {0, 0, 0, 2};
  const ImportedModel model = import(file);
  EXPECT_EQ(model.nodes[0].rotation.w, 1.0);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("nodes[0].rotation: of length 2"), std::string::npos) << model.warnings[0];
}

TEST_F(GltfScene, TheChosenSceneDecidesWhatIsDrawn) {
  GltfBuilder file = triangle_file();  // node 0
  file.node({{"mesh", 0}});
  file.node({{"children", {1}}});
  EXPECT_EQ(import(file).objects.size(), 2u) << "without scenes every root is drawn";
  file.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {2}}}};
  ImportedModel model = import(file);
  ASSERT_EQ(model.objects.size(), 1u) << "the first scene is the default";
  EXPECT_EQ(model.objects[0].node, 0);
  file.json["scene"] = 1;
  model = import(file);
  ASSERT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.objects[0].node, 1) << "a child is drawn with its root";
}

TEST_F(GltfScene, PerspectiveCameraInRadiansAndWithoutFarPlane) {
  GltfBuilder file = triangle_file();
  const int node = file.node({{"camera", 0}});
  file.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}}});
  const auto camera = import(file).camera;
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->node, node);
  const Perspective& lens = std::get<Perspective>(camera->projection);
  EXPECT_DOUBLE_EQ(lens.fovy_degrees, 90.0 / std::numbers::pi);
  EXPECT_EQ(lens.near, 0.25);
  EXPECT_TRUE(std::isinf(lens.far));
}

TEST_F(GltfScene, OrthographicCameraAndTheFirstOfSeveral) {
  GltfBuilder file = triangle_file();
  file.node({{"camera", 0}});
  file.node({{"camera", 0}});
  file.append("cameras",
              {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"znear", 0}, {"zfar", 9}}}});
  const ImportedModel model = import(file);
  const Orthographic& lens = std::get<Orthographic>(model.camera->projection);
  EXPECT_EQ(lens.left, -2);
  EXPECT_EQ(lens.right, 2);
  EXPECT_EQ(lens.top, 1);
  EXPECT_EQ(lens.far, 9);
  EXPECT_EQ(model.camera->node, 1);
  EXPECT_EQ(model.warnings, std::vector<std::string>{"several cameras: the first one is used"});
}

TEST_F(GltfScene, LightsStandWhereTheirNodesAre) {
  GltfBuilder file = triangle_file();
  const double quarter = std::sqrt(0.5);  // half of a right angle about y
  file.node({{"translation", {5, 0, 0}}, {"rotation", {0, quarter, 0, quarter}}, {"children", {2, 3, 4}}});
  for (int i = 0; i < 3; ++i)
    file.node({{"translation", {0, 0, 1}}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"color", {1, 0.5, 0}}, {"intensity", 2}}, {{"type", "point"}}, {{"type", "spot"}}};
  const ImportedModel model = import(file);
  ASSERT_EQ(model.lights.size(), 2u);
  constexpr double bound = 1e-15;  // a handful of roundings of numbers up to 6
  const glm::dvec3 towards = model.lights[0].vector - glm::dvec3(1, 0, 0),
                   place = model.lights[1].vector - glm::dvec3(6, 0, 0);
  EXPECT_LT(glm::length(towards), bound);
  EXPECT_LT(glm::length(place), 6 * bound);
  EXPECT_EQ(model.lights[0].kind, LightKind::directional);
  EXPECT_DOUBLE_EQ(model.lights[0].color.g, 1 / std::numbers::pi);
  EXPECT_EQ(model.lights[1].kind, LightKind::point);
  EXPECT_TRUE(model.lights[1].falloff);
  EXPECT_EQ(model.warnings, std::vector<std::string>{"not drawn: spot lights"});
}

TEST_F(GltfScene, WhatIsNotDrawnIsNamedInOneWarning) {
  GltfBuilder file = triangle_file();
  file.json["skins"] = {{{"joints", {0}}}};
  file.json["nodes"][0]["skin"] = 0;
  file.json["textures"] = nlohmann::json::array({nlohmann::json::object()});
  file.json["extensionsUsed"] = {"KHR_materials_unlit", "ACME_fur"};
  EXPECT_EQ(import(file).warnings, std::vector<std::string>{"not drawn: extension ACME_fur, skins, textures"});
}

TEST_F(GltfScene, NothingIsMoved) {
  const ImportedModel model = import(triangle_file());
  EXPECT_EQ(model.duration_seconds, 0);
  EXPECT_FALSE(model.camera);
  EXPECT_TRUE(model.lights.empty());
  EXPECT_TRUE(model.warnings.empty());
}

}  // namespace
}  // namespace morphcl::test
