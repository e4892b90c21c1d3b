// The colours that stand behind the coordinates of an .obj file's vertices, in the ways that exporters write them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace morphcl {

class ObjColors {
 public:
  static constexpr std::size_t max_numbers = 4, bytes_each = sizeof(std::array<float, max_numbers>) + 8;

  // What follows x y z of a vertex: r g b, w r g b, or r g b a; NaN for a word that is no number.
  void add(std::size_t vertex, std::span<const float> numbers);

  // One colour a vertex, each part from 0 to 1; nothing when no vertex has one. `warnings` says what was mended:
  // - numbers from 0 to 255 are divided by 255: none has a fraction, one exceeds 1;
  // - of four numbers the first is red, not a weight, when it varies and the fourth is 1 everywhere;
  // - what is outside 0 to 1 is clamped; a vertex whose colour is missing or no number has the default colour.
  std::vector<glm::vec3> finish(std::size_t vertex_count, const std::string& path, std::vector<std::string>& warnings);

 private:
  struct Entry {
    std::array<float, max_numbers> numbers;  // w r g b, w 1 where there is none
    std::uint32_t vertex;
    bool weighted;
  };
  bool red_comes_first(const std::string& path, std::vector<std::string>& warnings) const;

  std::vector<Entry> entries_;
};

}  // namespace morphcl
