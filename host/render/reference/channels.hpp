// The reference's view of kernels/shade_channels.h and kernels/sample_shares.h: what a pixel shows beside colour and
// distance.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "host/render/reference/visibility.hpp"

namespace morphcl::reference {

// At the centre of a pixel; 0 where nothing is seen.
struct Centre {
  glm::vec3 normal{0.0f}, position{0.0f};  // world space
  glm::vec2 velocity{0.0f};                // pixels to the next frame, u right, v up
  glm::vec2 uv{0.0f};
  glm::vec3 albedo{0.0f};
  std::uint32_t object_id = 0, material_id = 0;
};

// What the centres of a frame's pixels show. Plan and vertices outlive it.
class Centres {
 public:
  // `next`: the vertices of plan.next_draws, where there are any.
  Centres(const FramePlan& plan, const std::vector<std::vector<Vertex>>& vertices,
          const std::vector<std::vector<Vertex>>& next);

  // Of `surface`, which the pixel's centre shows. What the plan's channels do not ask for may be 0.
  Centre at(const Visibility& visible, const Sample& surface, int x, int y) const;

 private:
  std::array<std::uint32_t, 3> vertices_of(const Sample& sample) const;

  const FramePlan& plan_;
  const std::vector<std::vector<Vertex>>&vertices_, &next_;
  std::vector<std::vector<glm::uvec2>> edges_;  // of each draw of lines
};

// Share of a pixel's samples that show something.
float coverage_of(std::span<const Sample> samples);

enum class CryptoNames { objects, materials };
constexpr std::size_t crypto_ranks = 6;

// Id and share of the names with most samples in a pixel, sorted by the number of samples, of equal ones the name that
// is drawn first. 0 0 where there are fewer names; where there are more, the last are lost.
using CryptoRanks = std::array<std::array<float, 2>, crypto_ranks>;
CryptoRanks crypto_ranks_of(const FramePlan& plan, std::span<const Sample> samples, CryptoNames names);

}  // namespace morphcl::reference
