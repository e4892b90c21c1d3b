// What a glTF file says about looks alone: wrong, it costs a warning and never the model.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/scene/gltf/gltf_import.hpp"
#include "tests/scene/gltf_builder.hpp"
#include "tests/scene/import_error.hpp"

namespace morphcl::test {
namespace {

class GltfLooks : public testing::Test {
 protected:
  // Of the triangle with these attributes and this material.
  ImportedModel import(const nlohmann::json& material) {
    GltfBuilder file = triangle_file();
    if (!material.is_null()) file.json["meshes"][0]["primitives"][0]["material"] = file.append("materials", material);
    return import_gltf(file.write(folder), TimeBase{});
  }
  static nlohmann::json base(const nlohmann::json& factor) {
    return {{"pbrMetallicRoughness", {{"baseColorFactor", factor}}}};
  }
  static nlohmann::json with_alpha(const char* mode, double alpha) {
    nlohmann::json material = base({1, 0, 0, alpha});
    material["alphaMode"] = mode;
    return material;
  }
  static void expect_one_warning(const ImportedModel& model, const std::string& words) {
    ASSERT_EQ(model.warnings.size(), words.empty() ? 0u : 1u) << words;
    if (!words.empty()) {
      EXPECT_NE(model.warnings[0].find(words), std::string::npos) << model.warnings[0];
    }
  }
  test_support::TemporaryFolder folder;
};

TEST_F(GltfLooks, FactorsBeyondTheirRangeAreClamped) {
  const ImportedModel over = import(base({1.00016, -0.25, 0.5, 1}));
  EXPECT_EQ(over.objects[0].material.base_color, glm::dvec4(1, 0, 0.5, 1));
  ASSERT_EQ(over.warnings.size(), 2u);
  EXPECT_NE(over.warnings[0].find("baseColorFactor: holds 1.00016; factors are from 0 to 1, so it is clamped"),
            std::string::npos);
  for (const nlohmann::json& factor :
       {nlohmann::json("red"), nlohmann::json({1, 0, 0}), nlohmann::json({1, 0, nullptr, 1})}) {
    const ImportedModel broken = import(base(factor));
    EXPECT_EQ(broken.objects[0].material.base_color, glm::dvec4(1));
    expect_one_warning(broken, "the default colour is used");
  }
}

TEST_F(GltfLooks, AlphaBlendsMasksOrHides) {
  expect_one_warning(import(with_alpha("OPAQUE", 0)), "");
  expect_one_warning(import(with_alpha("BLEND", 1)), "");
  const auto material = [&](const char* mode, double alpha) {
    const ImportedModel model = import(with_alpha(mode, alpha));
    expect_one_warning(model, "");
    return model.objects.at(0).material;
  };
  EXPECT_EQ(material("OPAQUE", 0.5).base_color.a, 1);
  EXPECT_EQ(material("BLEND", 0.5).base_color.a, 0.5);
  EXPECT_EQ(material("BLEND", 0.5).alpha_mode, AlphaMode::blend);
  EXPECT_EQ(material("MASK", 0.75).base_color.a, 0.75);
  EXPECT_EQ(material("MASK", 0.75).alpha_mode, AlphaMode::mask);
  EXPECT_EQ(material("MASK", 0.75).alpha_cutoff, 0.5);
  EXPECT_EQ(import(with_alpha("OPAQUE", 0)).objects.size(), 1u);
  EXPECT_TRUE(import(with_alpha("BLEND", 0)).objects.empty());
  EXPECT_TRUE(import(with_alpha("MASK", 0.25)).objects.empty());
  nlohmann::json low = with_alpha("MASK", 0.25);
  low["alphaCutoff"] = 0.25;
  EXPECT_EQ(import(low).objects.size(), 1u);
  expect_one_warning(import(with_alpha("FADE", 0.5)), "is 'FADE'; OPAQUE, MASK or BLEND are modes, and OPAQUE is used");
}

TEST_F(GltfLooks, NormalsWithoutADirectionAreDropped) {
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  for (const std::vector<float>& last : {std::vector<float>{0, 0, 0}, {nan, 0, 1}, {infinity, 0, 0}}) {
    GltfBuilder file = triangle_file(1);
    nlohmann::json& primitive = file.json["meshes"][0]["primitives"][0];
    std::vector<float> normals = {0, 0, 1, 0, 0, 1};
    normals.insert(normals.end(), last.begin(), last.end());
    primitive["attributes"]["NORMAL"] = file.floats(normals, "VEC3");
    primitive["targets"][0]["NORMAL"] = file.floats({0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
    const ImportedModel model = import_gltf(file.write(folder), TimeBase{});
    EXPECT_TRUE(model.meshes[0].normals.empty());
    EXPECT_TRUE(model.meshes[0].targets[0].normals.empty());
    expect_one_warning(model, "1 of 3 normals are zero or no numbers, so the faces are lit flat");
    validate(model.meshes[0]);
  }
}

TEST_F(GltfLooks, ColorsThatAreNoNumbersAreWhite) {
  GltfBuilder file = triangle_file(1);
  nlohmann::json& primitive = file.json["meshes"][0]["primitives"][0];
  const float nan = std::nanf("");
  primitive["attributes"]["COLOR_0"] = file.floats({1, 0, 0, nan, 0, 0, 2, 0, 0}, "VEC3");
  primitive["targets"][0]["COLOR_0"] = file.floats({0, 0, nan, 0, 0, 0, 0, 0, 0}, "VEC3");
  const ImportedModel model = import_gltf(file.write(folder), TimeBase{});
  EXPECT_EQ(model.meshes[0].colors, (std::vector<glm::vec4>{{1, 0, 0, 1}, {1, 1, 1, 1}, {1, 0, 0, 1}}));
  EXPECT_TRUE(model.meshes[0].targets[0].colors.empty());
  EXPECT_EQ(model.warnings.size(), 3u);
}

TEST_F(GltfLooks, WhatIsNoMaterialOrNoNameIsNotUsed) {
  expect_one_warning(import({{"doubleSided", "yes"}}),
                     "must be true or false, not string; the default material is used");
  expect_one_warning(import({{"alphaMode", 3}}), "the default material is used");
  for (const char* array : {"nodes", "meshes", "scenes", "cameras", "animations"}) {
    GltfBuilder file = triangle_file();
    file.json["scenes"] = {{{"nodes", {0}}}};
    file.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}});
    file.animate(0, "translation", {0}, {0, 0, 0});
    file.json[array][0]["name"] = 7;
    const ImportedModel model = import_gltf(file.write(folder), TimeBase{});
    EXPECT_EQ(model.objects.size(), 1u) << array;
    expect_one_warning(model, std::string(array) + "[0].name: must be a string, not number; it is not used");
  }
}

TEST_F(GltfLooks, UrisAsExportersWriteThem) {
  GltfBuilder file = triangle_file();
  for (const std::string name : {"100%.bin", "a b.bin", "a%20b.bin", "a#b.bin"}) folder.write(name, file.bytes);
  folder.write("sub/data.bin", file.bytes);
  for (const std::string uri :
       {"100%.bin", "100%25.bin", "a b.bin", "a%20b.bin", "a#b.bin", "./a b.bin", "sub/data.bin", "sub\\data.bin"}) {
    file.json["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", uri}}};
    EXPECT_EQ(import_gltf(file.write(folder), TimeBase{}).objects.size(), 1u) << uri;
  }
}

}  // namespace
}  // namespace morphcl::test
