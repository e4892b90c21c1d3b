// Geometry out of glTF files: topology, attributes in every encoding, morph targets, materials.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <utility>

#include "host/scene/gltf/gltf_import.hpp"
#include "tests/scene/gltf_builder.hpp"

namespace morphcl::test {
namespace {

class GltfMeshes : public testing::Test {
 protected:
  ImportedModel import(const GltfBuilder& file) { return import_gltf(file.write(folder), TimeBase{}); }
  test_support::TemporaryFolder folder;
};

GltfBuilder five_points(int mode) {
  GltfBuilder file;
  file.mesh({{"mode", mode},
             {"attributes", {{"POSITION", file.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3")}}}});
  return file;
}

using Triangles = std::vector<glm::uvec3>;
using Edges = std::vector<glm::uvec2>;

TEST_F(GltfMeshes, TriangleStripsWindAlike) {
  EXPECT_EQ(import(five_points(5)).meshes[0].triangles, (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
}

TEST_F(GltfMeshes, TriangleFan) {
  EXPECT_EQ(import(five_points(6)).meshes[0].triangles, (Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
}

TEST_F(GltfMeshes, TrianglesLeaveOutWhatIsNotWhole) {
  EXPECT_EQ(import(five_points(4)).meshes[0].triangles, (Triangles{{0, 1, 2}}));
}

TEST_F(GltfMeshes, LineModesBecomeWireframes) {
  const Edges expected[] = {
      {{0, 1}, {2, 3}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}};
  for (int mode = 1; mode <= 3; ++mode) {
    const ImportedModel model = import(five_points(mode));
    EXPECT_EQ(model.meshes[0].edges, expected[mode - 1]) << "mode " << mode;
    EXPECT_TRUE(model.meshes[0].triangles.empty());
    EXPECT_EQ(model.objects[0].material.shading, Shading::wireframe);
  }
}

TEST_F(GltfMeshes, PointsAreNamedInTheWarning) {
  const ImportedModel model = import(five_points(0));
  EXPECT_TRUE(model.objects.empty());
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_EQ(model.warnings[0], "not drawn: points");
}

GltfBuilder with_uvs(const std::function<int(GltfBuilder&)>& accessor) {
  GltfBuilder file = triangle_file();
  const int uvs = accessor(file);
  file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = uvs;
  return file;
}

TEST_F(GltfMeshes, TextureCoordinatesHaveVUp) {
  const ImportedModel floats =
      import(with_uvs([](GltfBuilder& f) { return f.floats({0, 0, 0.25f, 1, 3, -0.5f}, "VEC2"); }));
  EXPECT_EQ(floats.meshes[0].uvs, (std::vector<glm::vec2>{{0, 1}, {0.25f, 0}, {3, 1.5f}}));
  EXPECT_TRUE(floats.warnings.empty());
  EXPECT_TRUE(import(triangle_file()).meshes[0].uvs.empty());
}

TEST_F(GltfMeshes, TextureCoordinatesOfNormalizedIntegers) {
  for (const int type : {uint8_type, uint16_type}) {
    const ImportedModel model = import(with_uvs([type](GltfBuilder& f) {
      const int accessor =
          type == uint8_type
              ? f.accessor(f.buffer_view(std::string("\x00\xff\x00\x00\x33\x00\x00\x00\xff\xff\x00\x00", 12), 4), type,
                           "VEC2", 3)
              : f.accessor(std::vector<std::uint16_t>{0, 65535, 13107, 0, 65535, 65535}, type, "VEC2");
      f.json["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
      return accessor;
    }));
    EXPECT_EQ(model.meshes[0].uvs, (std::vector<glm::vec2>{{0, 0}, {0.2f, 1}, {1, 0}})) << type;
  }
}

// They are seen in one channel alone, so the model is drawn all the same.
TEST_F(GltfMeshes, WrongTextureCoordinatesCostTheCoordinates) {
  const std::pair<std::function<int(GltfBuilder&)>, const char*> wrong[] = {
      {[](GltfBuilder& f) { return f.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3"); }, "is VEC3; VEC2 is needed here"},
      {[](GltfBuilder& f) { return f.floats({0, 0, 0, 1}, "VEC2"); }, "has 2 elements"},
      {[](GltfBuilder& f) { return f.accessor(std::vector<std::uint16_t>(6), uint16_type, "VEC2"); },
       "texture coordinates must be float or normalized unsigned integers of 8 or 16 bits"},
      {[](GltfBuilder&) { return 99; }, "99"},
  };
  for (const auto& [accessor, words] : wrong) {
    const ImportedModel model = import(with_uvs(accessor));
    ASSERT_EQ(model.meshes.size(), 1u) << words;
    EXPECT_TRUE(model.meshes[0].uvs.empty());
    ASSERT_EQ(model.warnings.size(), 1u) << words;
    EXPECT_NE(model.warnings[0].find(words), std::string::npos) << model.warnings[0];
    EXPECT_NE(model.warnings[0].find("the mesh has no texture coordinates then"), std::string::npos);
  }
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const ImportedModel model =
      import(with_uvs([](GltfBuilder& f) { return f.floats({nan, 1, 0.5f, infinity, 1, 1}, "VEC2"); }));
  EXPECT_EQ(model.meshes[0].uvs, (std::vector<glm::vec2>{{0, 0}, {0.5f, 0}, {1, 0}}));
}

TEST_F(GltfMeshes, MaterialsHaveTheirNames) {
  GltfBuilder file = triangle_file();
  EXPECT_EQ(import(file).objects[0].material.name, "");
  file.json["meshes"][0]["primitives"][0]["material"] = file.append("materials", {{"name", "Wüstensand"}});
  EXPECT_EQ(import(file).objects[0].material.name, "Wüstensand");
  file.json["materials"][0]["name"] = 7;
  EXPECT_EQ(import(file).objects[0].material.name, "") << "no text, no name";
}

TEST_F(GltfMeshes, IndicesOfEveryWidth) {
  for (const int type : {uint8_type, uint16_type, uint32_type}) {
    GltfBuilder file = five_points(4);
    const std::vector<std::uint32_t> indices = {4, 2, 0};
    file.json["meshes"][0]["primitives"][0]["indices"] =
        type == uint8_type    ? file.accessor<std::uint8_t>({4, 2, 0}, type, "SCALAR")
        : type == uint16_type ? file.accessor<std::uint16_t>({4, 2, 0}, type, "SCALAR")
                              : file.accessor(indices, type, "SCALAR");
    EXPECT_EQ(import(file).meshes[0].triangles, (Triangles{{4, 2, 0}})) << "component type " << type;
  }
}

TEST_F(GltfMeshes, InterleavedAttributes) {
  GltfBuilder file;
  std::string data;
  for (int i = 0; i < 3; ++i) {
    const float vertex[6] = {float(i), float(10 * i), 0.5f, 0, 0, 2};
    data.append(reinterpret_cast<const char*>(vertex), sizeof vertex);
  }
  const int view = file.buffer_view(data, 24);
  const int position = file.accessor(view, float_type, "VEC3", 3), normal = file.accessor(view, float_type, "VEC3", 3);
  file.json["accessors"][normal]["byteOffset"] = 12;
  file.mesh({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}});
  const ImportedModel model = import(file);
  const Mesh& mesh = model.meshes[0];
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0.5f}, {1, 10, 0.5f}, {2, 20, 0.5f}}));
  EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, {0, 0, 1}));  // scaled to unit length
  EXPECT_EQ(model.objects[0].material.shading, Shading::smooth);
}

TEST_F(GltfMeshes, QuantizedPositionsNormalsAndTargets) {
  GltfBuilder file;
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  // Each element is padded to 4 bytes as the specification asks.
  const std::vector<std::uint16_t> raw = {0, 1, 65535, 7, 32768, 2, 3, 7, 4, 5, 6, 7};
  const std::string data(reinterpret_cast<const char*>(raw.data()), raw.size() * 2);
  const int view = file.buffer_view(data, 8);
  const int integers = file.accessor(view, uint16_type, "VEC3", 3);
  const int normalized = file.accessor(view, uint16_type, "VEC3", 3);
  file.json["accessors"][normalized]["normalized"] = true;
  const int normals =
      file.accessor(file.buffer_view(std::string("\0\0\x7f\0\x81\0\0\0\x80\0\0\0", 12), 4), int8_type, "VEC3", 3);
  file.json["accessors"][normals]["normalized"] = true;
  file.mesh({{"attributes", {{"POSITION", integers}, {"NORMAL", normals}}},
             {"targets", {{{"POSITION", normalized}, {"NORMAL", normals}}}}});
  const ImportedModel model = import(file);
  const Mesh& mesh = model.meshes[0];
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 1, 65535}, {32768, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}, {-1, 0, 0}, {-1, 0, 0}}));  // -128 counts as -127
  const auto part = [](double c) { return static_cast<float>(c / 65535.0); };
  EXPECT_EQ(mesh.targets[0].positions[1], glm::vec3(part(32768), part(2), part(3)));
  EXPECT_EQ(mesh.targets[0].positions[0], glm::vec3(0, part(1), 1));
  EXPECT_EQ(mesh.targets[0].normals[2], glm::vec3(-1, 0, 0));
}

TEST_F(GltfMeshes, SparseAccessorOverZeros) {
  GltfBuilder file = five_points(4);
  const std::vector<float> moved = {1, 2, 3, 4, 5, 6};
  const std::string values(reinterpret_cast<const char*>(moved.data()), 24);
  const nlohmann::json sparse = {
      {"count", 2},
      {"indices", {{"bufferView", file.buffer_view(std::string("\1\0\4\0", 4))}, {"componentType", uint16_type}}},
      {"values", {{"bufferView", file.buffer_view(values)}}}};
  const int target =
      file.append("accessors", {{"componentType", float_type}, {"type", "VEC3"}, {"count", 5}, {"sparse", sparse}});
  file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
  EXPECT_EQ(import(file).meshes[0].targets[0].positions,
            (std::vector<glm::vec3>{{0, 0, 0}, {1, 2, 3}, {0, 0, 0}, {0, 0, 0}, {4, 5, 6}}));
}

TEST_F(GltfMeshes, SparseAccessorOverABufferView) {
  GltfBuilder file = five_points(4);
  file.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", file.buffer_view(std::string("\2", 1))}, {"componentType", uint8_type}}},
      {"values", {{"bufferView", file.buffer_view(std::string(12, '\0'))}}}};
  const std::vector<glm::vec3> positions = import(file).meshes[0].positions;
  EXPECT_EQ(positions[2], glm::vec3(0, 0, 0));
  EXPECT_EQ(positions[3], glm::vec3(1, 1, 0));
}

TEST_F(GltfMeshes, ColorsAreClampedAndOpaqueUnlessBlended) {
  GltfBuilder file = triangle_file();
  nlohmann::json& primitive = file.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["COLOR_0"] = file.floats({0.25f, 2, -1, 0.5f, 1, 1, 1, 1, 0, 0, 0, 0}, "VEC4");
  primitive["material"] =
      file.append("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 0.5}}}}});
  ImportedModel model = import(file);
  EXPECT_EQ(model.meshes[0].colors, (std::vector<glm::vec4>{{0.25f, 1, 0, 1}, {1, 1, 1, 1}, {0, 0, 0, 1}}));
  EXPECT_EQ(model.objects[0].material.base_color, glm::dvec4(0.5, 0.25, 1, 1));
  file.json["materials"][0]["alphaMode"] = "BLEND";
  model = import(file);
  EXPECT_EQ(model.meshes[0].colors[0], glm::vec4(0.25f, 1, 0, 0.5f));
  EXPECT_EQ(model.objects[0].material.base_color, glm::dvec4(0.5, 0.25, 1, 0.5));
}

TEST_F(GltfMeshes, NormalizedRgbColorsAndColorTargets) {
  GltfBuilder file = triangle_file(1);
  nlohmann::json& primitive = file.json["meshes"][0]["primitives"][0];
  const int color = file.accessor<std::uint8_t>({255, 51, 0, 0, 0, 0, 0, 0, 0}, uint8_type, "VEC3");
  file.json["accessors"][color]["normalized"] = true;
  primitive["attributes"]["COLOR_0"] = color;
  primitive["targets"][0]["COLOR_0"] = file.floats({-1, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  const Mesh mesh = import(file).meshes[0];
  EXPECT_EQ(mesh.colors[0], glm::vec4(1, static_cast<float>(51 / 255.0), 0, 1));
  EXPECT_EQ(mesh.targets[0].colors[0], glm::vec4(-1, 0, 0, 0));
}

TEST_F(GltfMeshes, MaterialsWithoutLightAndWithTwoSides) {
  GltfBuilder file = triangle_file();
  ImportedModel model = import(file);
  EXPECT_EQ(model.objects[0].material.base_color, glm::dvec4(1));
  EXPECT_EQ(model.objects[0].material.shading, Shading::smooth);
  EXPECT_FALSE(model.objects[0].material.double_sided);
  const nlohmann::json unlit = {{"KHR_materials_unlit", nlohmann::json::object()}};
  file.json["meshes"][0]["primitives"][0]["material"] =
      file.append("materials", {{"doubleSided", true}, {"extensions", unlit}, {"emissiveFactor", {0, 1, 0}}});
  model = import(file);
  EXPECT_EQ(model.objects[0].material.shading, Shading::unlit);
  EXPECT_TRUE(model.objects[0].material.double_sided);
  EXPECT_EQ(model.warnings, std::vector<std::string>{"not drawn: emission"});
}

TEST_F(GltfMeshes, TargetNamesFromExtrasOrNumbers) {
  GltfBuilder file = triangle_file(2);
  EXPECT_EQ(import(file).meshes[0].targets[1].name, "target1");
  file.json["meshes"][0]["extras"] = {{"targetNames", {"smile", "blink"}}};
  const ImportedModel named = import(file);
  EXPECT_EQ(named.meshes[0].targets[0].name, "smile");
  EXPECT_EQ(named.meshes[0].targets[1].name, "blink");
  EXPECT_EQ(named.meshes[0].targets[1].form, TargetForm::delta);
  EXPECT_TRUE(named.warnings.empty());
  file.json["meshes"][0]["extras"] = {{"targetNames", {"smile"}}};
  const ImportedModel misnamed = import(file);
  EXPECT_EQ(misnamed.meshes[0].targets[0].name, "target0");
  EXPECT_EQ(misnamed.warnings.size(), 1u);
}

TEST_F(GltfMeshes, TwoHundredAndSixtyTargetsAreKept) {
  const GltfBuilder file = triangle_file(260);
  const ImportedModel model = import(file);
  ASSERT_EQ(model.meshes[0].targets.size(), 260u);
  EXPECT_EQ(model.meshes[0].targets[259].positions[0], glm::vec3(0, 0, 260));
  EXPECT_EQ(model.objects[0].morph.weights.size(), 260u);
}

TEST_F(GltfMeshes, PrimitivesShareNodeAndWeights) {
  GltfBuilder file = triangle_file(2);
  file.json["meshes"][0]["primitives"].push_back(file.json["meshes"][0]["primitives"][0]);
  file.json["meshes"][0]["weights"] = {0.25, 0.75};
  file.json["meshes"][0]["name"] = "body";
  file.node({{"mesh", 0}, {"weights", {-1, 2}}, {"name", "second"}});
  const ImportedModel model = import(file);
  ASSERT_EQ(model.meshes.size(), 2u);
  EXPECT_EQ(model.meshes[1].name, "body.1");
  ASSERT_EQ(model.objects.size(), 4u);
  EXPECT_EQ(model.objects[3].name, "second.1");
  EXPECT_EQ(model.objects[3].mesh, 1);
  EXPECT_EQ(model.objects[3].node, 1);
  ASSERT_EQ(model.objects.size(), 4u);
  EXPECT_EQ(model.objects[1].morph.weights, (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(model.objects[2].morph.weights, (std::vector<double>{-1, 2}));  // the node's own come first
}

TEST_F(GltfMeshes, BinaryAndEmbeddedFilesHoldTheSame) {
  GltfBuilder file = triangle_file(1);
  const ImportedModel external = import(file), binary = import_gltf(file.write_binary(folder), TimeBase{});
  file.json["buffers"] = {
      {{"byteLength", 36},
       {"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}};
  file.json["bufferViews"].erase(1);
  file.json["accessors"].erase(1);
  file.json["meshes"][0]["primitives"][0].erase("targets");
  const ImportedModel embedded = import(file);
  EXPECT_EQ(external.meshes[0].positions, binary.meshes[0].positions);
  EXPECT_EQ(external.meshes[0].targets[0].positions, binary.meshes[0].targets[0].positions);
  EXPECT_EQ(external.meshes[0].positions, embedded.meshes[0].positions);
}

TEST_F(GltfMeshes, ContentHashCoversFileAndBuffers) {
  GltfBuilder file = triangle_file();
  const std::string first = import(file).content_hash;
  EXPECT_EQ(first.size(), 32u);
  EXPECT_EQ(import(file).content_hash, first);
  file.bytes[0] = 1;
  const std::string other_buffer = import(file).content_hash;
  EXPECT_NE(other_buffer, first);
  file.json["extras"] = 1;
  EXPECT_NE(import(file).content_hash, other_buffer);
}

}  // namespace
}  // namespace morphcl::test
