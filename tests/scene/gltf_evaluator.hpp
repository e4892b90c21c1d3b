// A second opinion on animated glTF files: the formulas of the specification in 64-bit-mantissa arithmetic, straight
// from the JSON and the buffers, sharing no code with the library. Reads .gltf files whose animated accessors are plain
// floats, each in a buffer file or data of its own, as exporters write them.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace morphcl::test {

using Real = long double;
static_assert(std::numeric_limits<Real>::digits >= 64);
using Matrix = std::array<std::array<Real, 4>, 4>;  // rows

class GltfEvaluator {
 public:
  // Key times are rounded to the nearest of `frames_per_second` * `ticks_per_frame` ticks a second, and a time that is
  // the float nearest to a frame's is that frame's, as the library documents.
  GltfEvaluator(const std::string& path, std::int64_t frames_per_second, std::int64_t ticks_per_frame);

  std::size_t node_count() const { return json_["nodes"].size(); }
  Matrix node_to_world(std::size_t node, std::int64_t tick) const;
  std::vector<Real> weights(std::size_t node, std::int64_t tick) const;  // of the node's mesh
  std::int64_t last_tick() const;
  const nlohmann::json& json() const { return json_; }

 private:
  std::int64_t tick_of(Real seconds) const;
  std::vector<Real> floats(std::size_t accessor) const;
  // The value of the first channel that drives `path` of the node; empty without one.
  std::vector<Real> animated(std::size_t node, const std::string& path, std::int64_t tick) const;
  std::vector<Real> sample(const nlohmann::json& sampler, bool rotation, std::int64_t tick) const;

  nlohmann::json json_;
  std::vector<std::string> buffers_;
  std::int64_t frames_per_second_, ticks_per_frame_, ticks_per_second_;
};

}  // namespace morphcl::test
