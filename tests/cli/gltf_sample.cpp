#include "tests/cli/gltf_sample.hpp"

#include <cstring>
#include <vector>

namespace morphcl::cli_test {

namespace {
constexpr std::size_t indices_at = 0, positions_at = 12, target_at = 48, times_at = 84, weights_at = 92, end_at = 100;
constexpr int float_type = 5126, uint_type = 5125;

template <typename Value>
void append(std::string& bytes, const std::vector<Value>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

nlohmann::json view(std::size_t at, std::size_t end) {
  return {{"buffer", 0}, {"byteOffset", at}, {"byteLength", end - at}};
}

nlohmann::json accessor(int view, int type, int count, const char* shape) {
  return {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}};
}
}  // namespace

GltfSample::GltfSample() {
  append<std::uint32_t>(buffer, {0, 1, 2});
  append<float>(buffer, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  append<float>(buffer, {0, 0, 0, 0, 0, 0, 0, 1, 0});
  append<float>(buffer, {0, 2});
  append<float>(buffer, {0, 1});

  json["asset"]["version"] = "2.0";
  json["scene"] = 0;
  json["scenes"] = {{{"nodes", {0}}}};
  json["nodes"] = {{{"name", "triangle"}, {"mesh", 0}}};
  json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", 1}}}, {"indices", 0}, {"targets", {{{"POSITION", 2}}}}}}}}};
  json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}},
                         {"samplers", {{{"input", 3}, {"output", 4}}}}}};
  json["buffers"] = {{{"byteLength", end_at}, {"uri", "data.bin"}}};
  json["bufferViews"] = {view(indices_at, positions_at), view(positions_at, target_at), view(target_at, times_at),
                         view(times_at, weights_at), view(weights_at, end_at)};
  json["accessors"] = {accessor(0, uint_type, 3, "SCALAR"), accessor(1, float_type, 3, "VEC3"),
                       accessor(2, float_type, 3, "VEC3"), accessor(3, float_type, 2, "SCALAR"),
                       accessor(4, float_type, 2, "SCALAR")};
  json["accessors"][1]["min"] = {0, 0, 0};
  json["accessors"][1]["max"] = {1, 1, 0};
  json["accessors"][3]["min"] = {0};
  json["accessors"][3]["max"] = {2};
}

void GltfSample::set_position(std::size_t index, float value) {
  std::memcpy(buffer.data() + positions_at + index * sizeof value, &value, sizeof value);
}

void GltfSample::set_index(std::size_t index, std::uint32_t value) {
  std::memcpy(buffer.data() + indices_at + index * sizeof value, &value, sizeof value);
}

}  // namespace morphcl::cli_test
