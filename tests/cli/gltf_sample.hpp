// A small valid glTF model that tests then damage in one place.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace morphcl::cli_test {

// One triangle with one morph target whose weight is animated over two seconds; the buffer is data.bin.
struct GltfSample {
  GltfSample();

  nlohmann::json json;
  std::string buffer;  // bytes of data.bin: indices, positions, target, times, weights

  // Overwrites a 4-byte float of the buffer; `index` counts floats from the start of accessor 1 (the positions).
  void set_position(std::size_t index, float value);
  void set_index(std::size_t index, std::uint32_t value);
};

}  // namespace morphcl::cli_test
