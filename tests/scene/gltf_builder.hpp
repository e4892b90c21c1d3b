// Builds small glTF files for the tests. The JSON is open, so that a test can damage it in any way.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {

// The component type numbers of the format.
constexpr int int8_type = 5120, uint8_type = 5121, int16_type = 5122, uint16_type = 5123, uint32_type = 5125,
              float_type = 5126;

struct GltfBuilder {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;  // of buffers[0]

  // Each appends to an array of the JSON and returns the index.
  int append(const char* array, nlohmann::json value);
  int buffer_view(const std::string& data, int stride = 0);
  int accessor(int view, int component, const char* type, std::size_t count);
  template <typename T>
  int accessor(const std::vector<T>& components, int component, const char* type) {
    const std::string data(reinterpret_cast<const char*>(components.data()), components.size() * sizeof(T));
    return accessor(buffer_view(data), component, type, components.size() / width(type));
  }
  int floats(const std::vector<float>& components, const char* type) { return accessor(components, float_type, type); }
  int node(nlohmann::json value) { return append("nodes", std::move(value)); }
  // A mesh of one primitive and a node that shows it; the index of the mesh.
  int mesh(nlohmann::json primitive);
  // One animation with one channel. Accessors are made for the keys, the times first.
  int animation(int node, const char* path, int input, int output, const char* interpolation = "LINEAR");
  int animate(int node, const std::string& path, const std::vector<float>& times, const std::vector<float>& values,
              const char* interpolation = "LINEAR");

  std::string write(const test_support::TemporaryFolder& folder,
                    const std::string& name = "model.gltf") const;  // and "model.bin"
  std::string write_binary(const test_support::TemporaryFolder& folder, const std::string& name = "model.glb") const;

  static std::size_t width(const std::string& type);
};

// A triangle in the plane z = 0 with `targets` morph targets, each moving all corners by its number + 1 along z.
GltfBuilder triangle_file(int targets = 0);

// A GLB of these chunks: JSON first, then binary if not empty.
std::string binary_gltf(std::string json, std::string binary);

}  // namespace morphcl::test
