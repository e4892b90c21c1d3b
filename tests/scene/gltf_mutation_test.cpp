// Damaged files: whatever bytes change, the import returns a model or throws Error, within its budget.
#include <gtest/gtest.h>

#include <random>

#include "host/scene/gltf/gltf_import.hpp"
#include "morphcl/error.hpp"
#include "morphcl/mesh.hpp"
#include "tests/scene/gltf_builder.hpp"

namespace morphcl::test {
namespace {

GltfBuilder file_with_everything() {
  GltfBuilder file = triangle_file(2);
  const int times = file.floats({0, 0.5f, 1}, "SCALAR");
  file.animation(0, "weights", times, file.floats({0, 0, 1, 0, 0, 1}, "SCALAR"));
  file.animation(0, "translation", times, file.floats(std::vector<float>(27, 0.5f), "VEC3"), "CUBICSPLINE");
  nlohmann::json& primitive = file.json["meshes"][0]["primitives"][0];
  primitive["indices"] = file.accessor<std::uint16_t>({0, 1, 2}, uint16_type, "SCALAR");
  primitive["material"] = file.append("materials", {{"doubleSided", true}});
  const int view = file.buffer_view(std::string("\1\0\0\0", 4)), values = file.buffer_view(std::string(12, '\1'));
  file.json["accessors"][0]["sparse"] = {{"count", 1},
                                         {"indices", {{"bufferView", view}, {"componentType", uint16_type}}},
                                         {"values", {{"bufferView", values}}}};
  file.node({{"camera", 0}, {"rotation", {0, 0.6, 0, 0.8}}, {"children", {0}}});
  file.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}}});
  file.json["scenes"] = {{{"nodes", {1}}}};
  return file;
}

TEST(GltfMutation, ChangedBytesAreRefusedOrRead) {
  const test_support::TemporaryFolder folder;
  const GltfBuilder file = file_with_everything();
  nlohmann::json json = file.json;
  json["buffers"] = {{{"byteLength", file.bytes.size()}}};
  const std::string whole = binary_gltf(json.dump(), file.bytes);
  ASSERT_EQ(import_gltf(folder.write("whole.glb", whole), TimeBase{}).objects.size(), 1u);

  ImportLimits limits;
  limits.max_vertices = 1 << 16;
  limits.max_decoded_bytes = 1 << 22;
  std::mt19937 random(20240229);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(random() % limit); };
  int read = 0, refused = 0;
  constexpr int files = 3000;
  const std::string alphabet = "0123456789-.e{}[],:\"\\ tfn\xff";
  for (int i = 0; i < files; ++i) {
    std::string bytes = whole;
    for (std::size_t change = 0; change <= below(3); ++change) {
      const std::size_t at = below(bytes.size());
      bytes[at] = below(2) == 0 ? alphabet[below(alphabet.size())] : static_cast<char>(below(256));
    }
    const std::string path = folder.write("damaged.glb", bytes);
    try {
      const ImportedModel model = import_gltf(path, TimeBase{}, limits);
      for (const Mesh& mesh : model.meshes) validate(mesh);
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      ++refused;
    }
  }
  EXPECT_EQ(read + refused, files);
  EXPECT_GT(read, files / 20);     // changes in the binary data and in names do no harm
  EXPECT_GT(refused, files / 20);  // changes in the JSON do
}

}  // namespace
}  // namespace morphcl::test
