// What is around the meshes of a glTF file: nodes, scenes, cameras, lights, and what is said to be left out.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/scene/gltf/gltf_import.hpp"
#include "tests/scene/gltf_builder.hpp"
#include "tests/scene/import_error.hpp"

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
  EXPECT_EQ(lens.fit, Fit::widen);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("several cameras, and the first is used"), std::string::npos) << model.warnings[0];
}

TEST_F(GltfScene, CamerasAreChosenByTheirNameTheirNodeOrTheirNumber) {
  GltfBuilder file = triangle_file();
  file.node({{"camera", 0}, {"name", "left eye"}});
  file.node({{"camera", 1}, {"name", "right eye"}});
  for (const double angle : {0.5, 0.75})
    file.append("cameras",
                {{"type", "perspective"}, {"perspective", {{"yfov", angle}, {"znear", 0.25}, {"aspectRatio", 2}}}});
  file.json["cameras"][1]["name"] = "lens";
  const std::string path = file.write(folder);
  for (const std::string wanted : {"lens", "right eye", "1"}) {
    const ImportedModel model = import_gltf(path, TimeBase{}, {}, {.camera = wanted});
    EXPECT_EQ(model.camera->node, 2) << wanted;
    EXPECT_EQ(model.camera_aspect, 2) << wanted;
    EXPECT_TRUE(model.warnings.empty()) << wanted;
    EXPECT_EQ(model.parts[0].name, "left eye") << "it has no name but its node's";
    EXPECT_FALSE(model.parts[0].used);
    EXPECT_TRUE(model.parts[1].used);
  }
  EXPECT_EQ(import(file).camera->node, 1);
  expect_refusal([&] { import_gltf(path, TimeBase{}, {}, {.camera = "2"}); }, ErrorKind::usage, path,
                 "there is no camera '2'; the file has 0 'left eye', 1 'lens'");
  EXPECT_TRUE(import_gltf_camera(path, TimeBase{}, {}, {}).objects.empty());
  expect_refusal([&] { import_gltf_camera(triangle_file().write(folder), TimeBase{}, {}, {}); }, ErrorKind::bad_input,
                 path, "holds no camera");
}

TEST_F(GltfScene, AspectsThatAreNoneAreTheImages) {
  GltfBuilder file = triangle_file();
  file.node({{"camera", 0}});
  file.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 1}, {"aspectRatio", 0}}}});
  const ImportedModel model = import(file);
  EXPECT_FALSE(model.camera_aspect);
  EXPECT_EQ(model.warnings.size(), 1u);
}

TEST_F(GltfScene, ScenesAreChosen) {
  GltfBuilder file = triangle_file();
  file.node({{"mesh", 0}});
  file.json["scenes"] = {{{"name", "empty"}}, {{"name", "full"}, {"nodes", {0, 1}}}};
  const std::string path = file.write(folder);
  EXPECT_EQ(import_gltf(path, TimeBase{}).objects.size(), 0u);
  EXPECT_EQ(import_gltf(path, TimeBase{}, {}, {.scene = "full"}).objects.size(), 2u);
  EXPECT_EQ(import_gltf(path, TimeBase{}, {}, {.scene = "1"}).objects.size(), 2u);
  expect_refusal([&] { import_gltf(path, TimeBase{}, {}, {.scene = "none"}); }, ErrorKind::usage, path,
                 "the file has 0 'empty', 1 'full'");
}

TEST_F(GltfScene, ASceneThatNamesAChildDrawsItWhereItsParentPutsIt) {
  GltfBuilder file = triangle_file();
  file.node({{"translation", {5, 0, 0}}, {"children", {0}}});
  file.json["scenes"] = {{{"nodes", {0}}}};
  const ImportedModel model = import(file);
  ASSERT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.nodes[0].parent, 1);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("scenes[0].nodes[0]: nodes[0] is a child of nodes[1]"), std::string::npos);
}

TEST_F(GltfScene, SkinnedMeshesStandAtTheOrigin) {
  GltfBuilder file = triangle_file(1);
  file.node({{"scale", {100, 100, 100}}, {"children", {0}}});
  file.json["skins"] = {{{"joints", {1}}}};
  file.json["nodes"][0]["skin"] = 0;
  file.json["nodes"][0]["translation"] = {1, 2, 3};
  file.animate(0, "weights", {0, 1}, {0, 1});
  const ImportedModel model = import(file);
  ASSERT_EQ(model.objects.size(), 1u);
  const Node& stand = model.nodes[static_cast<std::size_t>(model.objects[0].node)];
  EXPECT_EQ(stand.parent, -1);
  EXPECT_EQ(stand.translation, glm::dvec3(0));
  EXPECT_EQ(stand.static_transform, glm::dmat4(1));
  EXPECT_EQ(model.objects[0].morph.tracks.size(), 1u);
  ASSERT_EQ(model.warnings.size(), 2u);
  EXPECT_NE(model.warnings[1].find("stands unmoved at the origin"), std::string::npos);
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
  EXPECT_EQ(import(file).warnings[0], "not drawn: extension ACME_fur, skins, textures");
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
