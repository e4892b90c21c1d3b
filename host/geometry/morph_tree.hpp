// The drawn vertices of a mesh under morph weights: which of them reaches farthest, without touching them all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "morphcl/mesh.hpp"

namespace morphcl {

// The vertices that a mesh's triangles, or its edges where `wireframe`, name: each once, ascending.
std::vector<std::uint32_t> drawn_vertices(const Mesh& mesh, bool wireframe);

// base + sum w (target - base) in binary64: what renderers draw but for their rounding.
glm::dvec3 morphed_vertex(const Mesh& mesh, std::span<const double> weights, std::uint32_t vertex);

struct FarthestVertex {
  double distance;  // along the direction asked for
  std::uint32_t vertex;
};

// Boxes about vertices that lie together, and about such boxes, of the base and of what each target adds. Morphs are
// affine in their weights, so the reach of a box under weights is the sum of its boxes' reaches times weights.
//
// Method: vertices in the order of their Morton code in the base (30 bits), boxes about 32 of them, then about 8 boxes
// of the level below; branch and bound. O(n log n + vertices x targets) to build; memory 55 bytes for 32 vertices, base
// and each target.
class MorphTree {
 public:
  MorphTree(const Mesh& mesh, const std::vector<std::uint32_t>& vertices);  // the mesh outlives this

  // The vertex whose place under the weights, one a target, reaches farthest along `direction`; none unless it reaches
  // farther than `beyond`. What is within rounding of the farthest may be taken for it.
  std::optional<FarthestVertex> farthest(std::span<const double> weights, const glm::dvec3& direction,
                                         double beyond) const;

 private:
  static constexpr std::size_t leaf_size = 32, fan_out = 8;
  struct Range {
    glm::dvec3 center{0.0}, half{0.0};
  };
  struct Search;

  double reach(std::size_t level, std::size_t index, const Search& search) const;
  void search_below(std::size_t level, std::size_t index, Search& search) const;

  const Mesh* mesh_;
  std::vector<std::uint32_t> order_;
  std::size_t sets_ = 1;                    // the base, and each target
  std::vector<std::vector<Range>> levels_;  // from the leaves up: `sets_` ranges a box
};

}  // namespace morphcl
