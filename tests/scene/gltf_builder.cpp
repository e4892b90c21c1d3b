#include "tests/scene/gltf_builder.hpp"

namespace morphcl::test {

namespace {

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
  return bytes;
}

std::string padded(std::string bytes, char with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
  return bytes;
}

}  // namespace

int GltfBuilder::append(const char* array, nlohmann::json value) {
  json[array].push_back(std::move(value));
  return static_cast<int>(json[array].size()) - 1;
}

int GltfBuilder::buffer_view(const std::string& data, int stride) {
  bytes = padded(bytes, '\0');
  nlohmann::json view = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
  if (stride > 0) view["byteStride"] = stride;
  bytes += data;
  return append("bufferViews", view);
}

int GltfBuilder::accessor(int view, int component, const char* type, std::size_t count) {
  return append("accessors", {{"bufferView", view}, {"componentType", component}, {"type", type}, {"count", count}});
}

std::size_t GltfBuilder::width(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : 4;
}

int GltfBuilder::mesh(nlohmann::json primitive) {
  const int index = append("meshes", {{"primitives", nlohmann::json::array({std::move(primitive)})}});
  node({{"mesh", index}});
  return index;
}

int GltfBuilder::animation(int node, const char* path, int input, int output, const char* interpolation) {
  return append(
      "animations",
      {{"samplers", nlohmann::json::array({{{"input", input}, {"output", output}, {"interpolation", interpolation}}})},
       {"channels", nlohmann::json::array({{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}})}});
}

int GltfBuilder::animate(int node, const std::string& path, const std::vector<float>& times,
                         const std::vector<float>& values, const char* interpolation) {
  const int input = floats(times, "SCALAR");
  const int output = floats(values, path == "weights" ? "SCALAR" : path == "rotation" ? "VEC4" : "VEC3");
  return animation(node, path.c_str(), input, output, interpolation);
}

std::string GltfBuilder::write(const test_support::TemporaryFolder& folder, const std::string& name) const {
  nlohmann::json file = json;
  if (!file.contains("buffers")) file["buffers"] = {{{"byteLength", bytes.size()}, {"uri", "model.bin"}}};
  folder.write("model.bin", bytes);
  return folder.write(name, file.dump());
}

std::string GltfBuilder::write_binary(const test_support::TemporaryFolder& folder, const std::string& name) const {
  nlohmann::json file = json;
  file["buffers"] = {{{"byteLength", bytes.size()}}};
  return folder.write(name, binary_gltf(file.dump(), bytes));
}

GltfBuilder triangle_file(int targets) {
  GltfBuilder file;
  nlohmann::json primitive = {{"attributes", {{"POSITION", file.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")}}}};
  for (int t = 0; t < targets; ++t) {
    const float z = static_cast<float>(t + 1);
    primitive["targets"].push_back({{"POSITION", file.floats({0, 0, z, 0, 0, z, 0, 0, z}, "VEC3")}});
  }
  file.mesh(primitive);
  return file;
}

std::string binary_gltf(std::string json, std::string binary) {
  json = padded(std::move(json), ' ');
  binary = padded(std::move(binary), '\0');
  std::string chunks = little_endian(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
  if (!binary.empty())
    chunks += little_endian(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
  return "glTF" + little_endian(2) + little_endian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

}  // namespace morphcl::test
