// Broken and hostile glTF files: each is refused by one line that says where and why.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "host/scene/gltf/gltf_import.hpp"
#include "tests/scene/gltf_builder.hpp"
#include "tests/scene/import_error.hpp"

namespace morphcl::test {
namespace {

class GltfBadInput : public testing::Test {
 protected:
  void expect_bad(const GltfBuilder& file, const std::string& json_path, const std::string& words) {
    const std::string path = file.write(folder);
    expect_refusal([&] { import_gltf(path, TimeBase{}); }, ErrorKind::bad_input,
                   json_path.empty() ? path : path + ": " + json_path, words);
  }
  void expect_bad_bytes(const std::string& name, const std::string& bytes, const std::string& place_after_path,
                        const std::string& words) {
    const std::string path = folder.write(name, bytes);
    expect_refusal([&] { import_gltf(path, TimeBase{}); }, ErrorKind::bad_input, path + place_after_path, words);
  }
  test_support::TemporaryFolder folder;
};

TEST_F(GltfBadInput, MissingFile) {
  const std::string path = (folder.path() / "none.gltf").string();
  expect_refusal([&] { import_gltf(path, TimeBase{}); }, ErrorKind::cannot_read, path, "No such file");
}

TEST_F(GltfBadInput, FolderInsteadOfFile) {
  const std::string path = folder.path().string();
  expect_refusal([&] { import_gltf(path, TimeBase{}); }, ErrorKind::cannot_read, path, "not a regular file");
}

TEST_F(GltfBadInput, MissingBufferFile) {
  GltfBuilder file = triangle_file();
  file.json["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "other.bin"}}};
  const std::string path = file.write(folder);
  const std::string buffer = std::filesystem::canonical(folder.path()) / "other.bin";
  expect_refusal([&] { import_gltf(path, TimeBase{}); }, ErrorKind::cannot_read, buffer, "No such file");
}

TEST_F(GltfBadInput, Utf16IsNamed) {
  std::string text = "\xfe\xff";
  for (const char c : std::string("{\"asset\": {\"version\": \"2.0\"}}")) text += {'\0', c};
  expect_bad_bytes("model.gltf", text, "", "is text in UTF-16; save it as UTF-8");
}

TEST_F(GltfBadInput, TruncatedJson) {
  expect_bad_bytes("model.gltf", "{\"asset\": {\"version\"", ":1:21", "truncated");
}

TEST_F(GltfBadInput, NotJson) { expect_bad_bytes("model.gltf", "{\n  \"asset\" oops", ":2:11", "not valid JSON"); }

TEST_F(GltfBadInput, EmptyFile) { expect_bad_bytes("model.gltf", "", ":1:1", "truncated"); }

TEST_F(GltfBadInput, TruncatedBinaryAtEveryLength) {
  const GltfBuilder builder = triangle_file();
  nlohmann::json json = builder.json;
  json["buffers"] = {{{"byteLength", builder.bytes.size()}}};
  const std::string whole = binary_gltf(json.dump(), builder.bytes);
  ASSERT_EQ(import_gltf(folder.write("whole.glb", whole), TimeBase{}).meshes.size(), 1u);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string path = folder.write("cut.glb", whole.substr(0, length));
    EXPECT_THROW(import_gltf(path, TimeBase{}), Error) << "cut to " << length << " of " << whole.size() << " bytes";
  }
}

TEST_F(GltfBadInput, TruncatedBuffer) {
  GltfBuilder file = triangle_file();
  file.json["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "model.bin"}}};
  file.bytes.pop_back();
  expect_bad(file, "buffers[0]", "there are 35 bytes: the data is truncated");
}

TEST_F(GltfBadInput, AccessorOutOfBounds) {
  GltfBuilder file = triangle_file();
  file.json["accessors"][0]["count"] = 4;
  expect_bad(file, "accessors[0]", "bytes 0 to 48 lie outside bufferViews[0] of 36 bytes");
}

TEST_F(GltfBadInput, AccessorOffsetThatWrapsAround) {
  GltfBuilder file = triangle_file();
  file.json["accessors"][0]["byteOffset"] = 9007199254740991;  // 2^53 - 1
  expect_bad(file, "accessors[0]", "lie outside bufferViews[0]");
}

TEST_F(GltfBadInput, BufferViewOutOfBounds) {
  GltfBuilder file = triangle_file();
  file.json["bufferViews"][0]["byteOffset"] = 4;
  expect_bad(file, "bufferViews[0]", "outside buffers[0] of 36 bytes");
}

TEST_F(GltfBadInput, StrideSmallerThanTheElement) {
  GltfBuilder file = triangle_file();
  file.json["bufferViews"][0]["byteStride"] = 8;
  expect_bad(file, "bufferViews[0].byteStride", "accessors[0] needs it from 12 to 252");
}

TEST_F(GltfBadInput, UnusedAccessorOutOfBounds) {
  GltfBuilder file = triangle_file();
  file.accessor(0, float_type, "VEC4", 3);
  expect_bad(file, "accessors[1]", "bytes 0 to 48 lie outside");
}

TEST_F(GltfBadInput, IndexOutOfRange) {
  GltfBuilder file = triangle_file();
  file.json["meshes"][0]["primitives"][0]["indices"] = file.accessor<std::uint16_t>({0, 1, 3}, uint16_type, "SCALAR");
  expect_bad(file, "accessors[1]", "index 2 is 3, but meshes[0].primitives[0] has 3 vertices");
}

TEST_F(GltfBadInput, IndicesOfSignedIntegers) {
  GltfBuilder file = triangle_file();
  file.json["meshes"][0]["primitives"][0]["indices"] = file.accessor<std::int16_t>({0, 1, 2}, int16_type, "SCALAR");
  expect_bad(file, "accessors[1]", "unsigned");
}

TEST_F(GltfBadInput, NanPosition) {
  GltfBuilder file;
  file.mesh({{"attributes", {{"POSITION", file.floats({0, 0, 0, 1, std::nanf(""), 0, 0, 1, 0}, "VEC3")}}}});
  expect_bad(file, "accessors[0]", "component 1 of element 1 is nan; it must be finite");
}

TEST_F(GltfBadInput, InfinitePosition) {
  GltfBuilder file;
  const float infinity = std::numeric_limits<float>::infinity();
  file.mesh({{"attributes", {{"POSITION", file.floats({0, 0, 0, 1, 0, 0, 0, 1, -infinity}, "VEC3")}}}});
  expect_bad(file, "accessors[0]", "component 2 of element 2 is -inf");
}

TEST_F(GltfBadInput, NumberBeyondDouble) {
  expect_bad_bytes("model.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"translation":[1e999,0,0]}]})", "",
                   "beyond the range");
}

TEST_F(GltfBadInput, TargetCountsThatDiffer) {
  GltfBuilder file = triangle_file(2);
  nlohmann::json second = file.json["meshes"][0]["primitives"][0];
  second["targets"].erase(1);
  file.json["meshes"][0]["primitives"].push_back(second);
  expect_bad(file, "meshes[0].primitives[1]", "has 1 morph targets, primitives[0] has 2");
}

TEST_F(GltfBadInput, TargetOfAnotherVertexCount) {
  GltfBuilder file = triangle_file(1);
  file.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = file.floats({0, 0, 0, 1, 1, 1}, "VEC3");
  expect_bad(file, "accessors[2]", "has 2 elements, but meshes[0].primitives[0] has 3 vertices");
}

TEST_F(GltfBadInput, WeightsThatDoNotFitTheTargets) {
  GltfBuilder file = triangle_file(2);
  file.json["meshes"][0]["weights"] = {0.5};
  expect_bad(file, "meshes[0].weights", "has 1 numbers; 2 are needed");
  file.json["meshes"][0].erase("weights");
  file.json["nodes"][0]["weights"] = {1, 2, 3};
  expect_bad(file, "nodes[0].weights", "has 3 numbers; 2 are needed");
}

TEST_F(GltfBadInput, NodeCycle) {
  GltfBuilder file;
  file.node({{"children", {1}}});
  file.node({{"children", {2}}});
  file.node({{"children", {1}}});
  expect_bad(file, "nodes[2].children[0]", "nodes[1] is already a child of nodes[0]");
  file.json["nodes"][0].erase("children");
  expect_bad(file, "nodes[1]", "2 nodes are each other's parents");
}

TEST_F(GltfBadInput, NodeThatIsItsOwnChild) {
  GltfBuilder file;
  file.node({{"children", {0}}});
  expect_bad(file, "nodes[0]", "hierarchy has no cycle");
}

TEST_F(GltfBadInput, HierarchyOfTwoHundredThousandNodesIsNoCrash) {
  constexpr int depth = 200'000;
  std::string text = R"({"asset":{"version":"2.0"},"nodes":[)";
  for (int i = 0; i + 1 < depth; ++i) text += "{\"children\":[" + std::to_string(i + 1) + "]},";
  const std::string open = folder.write("deep.gltf", text + "{}]}");
  EXPECT_EQ(import_gltf(open, TimeBase{}).nodes.size(), std::size_t{depth});
  expect_bad_bytes("cycle.gltf", text + "{\"children\":[0]}]}", ": nodes[0]", "200000 nodes are each other's parents");
}

TEST_F(GltfBadInput, DeeplyNestedExtrasAreNoCrash) {
  constexpr int depth = 200'000;
  std::string text = R"({"asset":{"version":"2.0"},"extras":)";
  text += std::string(depth, '[') + std::string(depth, ']') + "}";
  EXPECT_TRUE(import_gltf(folder.write("deep.gltf", text), TimeBase{}).objects.empty());
}

TEST_F(GltfBadInput, BufferPathThatLeavesTheFolder) {
  GltfBuilder file = triangle_file();
  folder.write("outside.bin", file.bytes);
  for (const std::string uri : {"../outside.bin", "%2e%2e/outside.bin", "a/../../outside.bin", "/etc/passwd",
                                "file:///etc/passwd", "http://example.com/a.bin"}) {
    file.json["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", uri}}};
    const std::string path = folder.write("models/model.gltf", file.json.dump());
    expect_refusal([&] { import_gltf(path, TimeBase{}); }, ErrorKind::bad_input, path + ": buffers[0].uri",
                   "--allow-outside");
  }
}

TEST_F(GltfBadInput, BufferPathThroughASymbolicLink) {
  GltfBuilder file = triangle_file();
  folder.write("outside.bin", file.bytes);
  file.json["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "link.bin"}}};
  const std::string path = folder.write("models/model.gltf", file.json.dump());
  std::filesystem::create_symlink("../outside.bin", folder.path() / "models/link.bin");
  expect_refusal([&] { import_gltf(path, TimeBase{}); }, ErrorKind::bad_input, path + ": buffers[0].uri",
                 "'link.bin' leaves the folder");
  ImportLimits limits;
  limits.allow_outside = true;
  EXPECT_EQ(import_gltf(path, TimeBase{}, limits).meshes.size(), 1u);
}

TEST_F(GltfBadInput, ClaimOf2To40Vertices) {
  GltfBuilder file = triangle_file();
  file.json["accessors"][0]["count"] = 1099511627776;
  expect_bad(file, "accessors[0].count", "claims 1099511627776 elements; at most 134217728 are read");
}

TEST_F(GltfBadInput, SparseClaimOf2To40VerticesWithoutData) {
  GltfBuilder file = triangle_file();
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 1099511627776;
  expect_bad(file, "accessors[0].count", "claims 1099511627776 elements");
}

TEST_F(GltfBadInput, ManyAccessorsOfZerosStayWithinTheBudget) {
  GltfBuilder file;
  nlohmann::json primitive = {{"attributes", {{"POSITION", 0}}}};
  file.append("accessors", {{"componentType", float_type}, {"type", "VEC3"}, {"count", 1000}});
  file.mesh(primitive);
  for (int i = 0; i < 100; ++i) file.json["meshes"][0]["primitives"].push_back(primitive);
  ImportLimits limits;
  limits.max_decoded_bytes = 1'000'000;  // each primitive takes 40,000 and more
  const std::string path = file.write(folder);
  try {
    import_gltf(path, TimeBase{}, limits);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("one model may take"), std::string::npos) << error.what();
  }
}

TEST_F(GltfBadInput, SparseIndicesThatDoNotIncrease) {
  GltfBuilder file = triangle_file();
  file.json["accessors"][0]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", file.buffer_view(std::string("\1\1", 2))}, {"componentType", uint8_type}}},
      {"values", {{"bufferView", file.buffer_view(std::string(24, '\0'))}}}};
  expect_bad(file, "accessors[0]", "sparse index 1 is 1; indices must increase");
}

TEST_F(GltfBadInput, AnimationSamplerCountMismatch) {
  GltfBuilder file = triangle_file();
  file.animate(0, "translation", {0, 1}, {0, 0, 0});
  expect_bad(file, "accessors[2]", "has 1 elements; 2 keys need 2");
}

TEST_F(GltfBadInput, AnimationTimesThatDoNotIncrease) {
  GltfBuilder file = triangle_file();
  file.animate(0, "translation", {0, 0.5f, 0.25f}, std::vector<float>(9));
  expect_bad(file, "accessors[1]", "key 1 is at 0.5 s, key 2 at 0.25 s; times must increase");
}

TEST_F(GltfBadInput, AnimationTimeBeyondTheTicks) {
  GltfBuilder file = triangle_file();
  file.animate(0, "translation", {1e30f}, {0, 0, 0});
  expect_bad(file, "accessors[1]", "key 0: ");
}

TEST_F(GltfBadInput, AnimationOfWrongTypes) {
  GltfBuilder file = triangle_file();
  file.animation(0, "rotation", file.floats({0}, "SCALAR"), 0);
  expect_bad(file, "accessors[0]", "must be VEC4 of float (5126) or normalized integers");
  file.json["animations"] = nlohmann::json::array();
  file.animation(0, "scale", 0, 0);
  expect_bad(file, "accessors[0]", "must be SCALAR float (5126) to hold key times");
}

TEST_F(GltfBadInput, AnimationOfWeightsWithoutTargets) {
  GltfBuilder file = triangle_file();
  const int scalar = file.floats({0}, "SCALAR");
  file.animation(0, "weights", scalar, scalar);
  expect_bad(file, "animations[0].channels[0].target", "nodes[0] has no morph targets");
}

TEST_F(GltfBadInput, AnimationOfANodeWithAMatrix) {
  GltfBuilder file = triangle_file();
  file.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  file.animate(0, "translation", {0}, {0, 0, 0});
  expect_bad(file, "animations[0].channels[0].target", "nodes[0] has a matrix");
}

TEST_F(GltfBadInput, CubicSplineOfOneKey) {
  GltfBuilder file = triangle_file();
  file.animate(0, "translation", {0}, std::vector<float>(9), "CUBICSPLINE");
  expect_bad(file, "accessors[1]", "a cubic spline needs two");
}

TEST_F(GltfBadInput, RotationKeyWithoutDirection) {
  GltfBuilder file = triangle_file();
  file.animate(0, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, 0, 0});
  expect_bad(file, "accessors[2]", "the rotation of key 1 has no direction");
}

TEST_F(GltfBadInput, UnknownRequiredExtension) {
  GltfBuilder file = triangle_file();
  file.json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_draco_mesh_compression"};
  expect_bad(file, "extensionsRequired[1]", "'KHR_draco_mesh_compression' is required");
  for (const char* name : {"EXT_meshopt_compression", "EXT_mesh_gpu_instancing", "KHR_node_visibility",
                           "KHR_animation_pointer", "KHR_gaussian_splatting"}) {
    file.json["extensionsRequired"] = {name};
    expect_bad(file, "extensionsRequired[0]", std::string(name) + "' is required");
  }
}

TEST_F(GltfBadInput, RequiredExtensionsOfLooksAreNamed) {
  for (const char* name : {"KHR_materials_clearcoat", "EXT_texture_avif", "MSFT_texture_dds", "KHR_audio", "VRM",
                           "KHR_xmp_json_ld", "EXT_lights_image_based", "ACME_notes"}) {
    GltfBuilder file = triangle_file();
    file.json["extensionsRequired"] = {name};
    file.json["extensions"] = {{name, nlohmann::json::object()}};
    const ImportedModel model = import_gltf(file.write(folder), TimeBase{});
    EXPECT_EQ(model.objects.size(), 1u) << name;
    EXPECT_EQ(model.warnings, std::vector<std::string>{std::string("not drawn: extension ") + name});
  }
}

// Nobody knows what it does, so where it stands decides.
TEST_F(GltfBadInput, UnknownRequiredExtensionWhereGeometryIs) {
  const nlohmann::json extension = {{"ACME_fur", nlohmann::json::object()}};
  const auto with = [](const std::function<void(nlohmann::json&)>& change) {
    GltfBuilder file = triangle_file();
    file.json["extensionsRequired"] = {"ACME_fur"};
    change(file.json);
    return file;
  };
  const auto place = [](const std::string& where) { return "is not known; it stands in " + where; };
  for (const char* array : {"nodes", "meshes", "accessors", "bufferViews"})
    expect_bad(with([&](nlohmann::json& json) { json[array][0]["extensions"] = extension; }), "extensionsRequired[0]",
               place(std::string(array) + "[0]"));
  expect_bad(with([&](nlohmann::json& json) { json["meshes"][0]["primitives"][0]["extensions"] = extension; }),
             "extensionsRequired[0]", place("meshes[0].primitives[0]"));
  const GltfBuilder material = with([&](nlohmann::json& json) { json["materials"] = {{{"extensions", extension}}}; });
  EXPECT_EQ(import_gltf(material.write(folder), TimeBase{}).warnings.size(), 1u);
}

TEST_F(GltfBadInput, PointersAtMaterialsAloneAreNamed) {
  GltfBuilder file = triangle_file();
  file.json["extensionsRequired"] = {"KHR_animation_pointer"};
  file.animate(0, "pointer", {0, 1}, {0, 0, 0, 1, 1, 1});
  nlohmann::json& target = file.json["animations"][0]["channels"][0]["target"];
  target.erase("node");
  target["extensions"]["KHR_animation_pointer"]["pointer"] = "/materials/0/emissiveFactor";
  EXPECT_EQ(import_gltf(file.write(folder), TimeBase{}).warnings,
            std::vector<std::string>{"not drawn: extension KHR_animation_pointer"});
  target["extensions"]["KHR_animation_pointer"]["pointer"] = "/nodes/0/translation";
  expect_bad(file, "extensionsRequired[0]", "'KHR_animation_pointer' is required");
}

TEST_F(GltfBadInput, SmallFilesThatClaimMuchCostLittle) {
  GltfBuilder file = triangle_file();
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 1 << 25;
  expect_bad(file, "accessors[0]", "that one model of its size may take");
}

TEST_F(GltfBadInput, IntegerPositionsWithoutTheExtension) {
  GltfBuilder file;
  file.mesh({{"attributes",
              {{"POSITION", file.accessor(file.buffer_view(std::string(36, '\0'), 12), int16_type, "VEC3", 3)}}}});
  expect_bad(file, "accessors[0]", "KHR_mesh_quantization");
}

TEST_F(GltfBadInput, ValuesOfWrongJsonTypes) {
  struct Case {
    const char *array, *key;
    nlohmann::json value;
    const char *path, *words;
  };
  const Case cases[] = {
      {"nodes", "mesh", "0", "nodes[0].mesh", "must be a number, not string"},
      {"nodes", "mesh", 0.5, "nodes[0].mesh", "whole number"},
      {"nodes", "mesh", -1, "nodes[0].mesh", "whole number"},
      {"nodes", "mesh", 4294967296, "nodes[0].mesh", "names meshes[4294967296], but there are 1"},
      {"nodes", "translation", {1, 2}, "nodes[0].translation", "has 2 numbers; 3 are needed"},
      {"nodes", "translation", {1, 2, "3"}, "nodes[0].translation[2]", "must be a number"},
      {"nodes", "rotation", {0, 0, 0, 0}, "nodes[0].rotation", "has no direction"},
      {"nodes", "children", 3, "nodes[0].children", "must be an array"},
      {"nodes", "matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "nodes[0].matrix", "last row"},
      {"accessors", "componentType", 5124, "accessors[0].componentType", "component types"},
      {"accessors", "type", "VEC5", "accessors[0].type", "'VEC5'"},
      {"accessors", "normalized", 1, "accessors[0].normalized", "true or false"},
      {"meshes", "primitives", nullptr, "meshes[0].primitives", "must be an array, not null"},
  };
  for (const Case& bad : cases) {
    GltfBuilder file = triangle_file();
    file.json[bad.array][0][bad.key] = bad.value;
    expect_bad(file, bad.path, bad.words);
  }
}

TEST_F(GltfBadInput, AnotherVersion) {
  GltfBuilder file = triangle_file();
  file.json["asset"]["version"] = "1.0";
  expect_bad(file, "asset.version", "is '1.0'; glTF 2.0 is read");
}

TEST_F(GltfBadInput, DataUriThatIsNotBase64) {
  GltfBuilder file = triangle_file();
  file.json["buffers"] = {{{"byteLength", 36}, {"uri", "data:application/octet-stream;base64,AA*A"}}};
  expect_bad(file, "buffers[0].uri", "character 2 of the data is not base64");
}

}  // namespace
}  // namespace morphcl::test
