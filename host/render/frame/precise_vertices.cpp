#include "host/render/frame/precise_vertices.hpp"

#include <cmath>

#include "host/render/frame/two_float.hpp"

namespace morphcl::reference {

namespace {

TwoFloat morphed(const Draw& draw, std::size_t vertex, int component) {
  const TwoFloat base{draw.mesh->positions[vertex][component], 0.0f};
  TwoFloat value = base;
  for (const ActiveTarget& active : draw.targets) {
    const std::vector<glm::vec3>& target = draw.mesh->targets[active.target].positions;
    if (target.empty()) continue;
    const TwoFloat weight{active.weight, active.weight_rest};
    if (active.base_weight != 0.0f) value = value - weight * base;
    value = value + weight * TwoFloat{target[vertex][component], 0.0f};
  }
  return value;
}

float two_float_row_times_point(const Row& row, const Row& rest, const TwoFloat position[3]) {
  TwoFloat sum{row[3], rest[3]};
  for (int c = 2; c >= 0; --c) sum = sum + TwoFloat{row[c], rest[c]} * position[c];
  return sum.high;
}

}  // namespace

glm::vec3 pivot_position(const Draw& draw, std::size_t vertex) {
  glm::vec3 position;
  for (int c = 0; c < 3; ++c) {
    const float pivot = draw.accuracy->pivot[c], base = draw.mesh->positions[vertex][c] - pivot;
    float value = base;
    for (const ActiveTarget& active : draw.targets) {
      const std::vector<glm::vec3>& target = draw.mesh->targets[active.target].positions;
      if (target.empty()) continue;
      const float end = active.base_weight != 0.0f ? target[vertex][c] - pivot : target[vertex][c];
      value = std::fma(active.weight, end, std::fma(active.base_weight, base, value));
    }
    position[c] = value;
  }
  return position;
}

void set_two_float_clip_point(const Draw& draw, std::size_t index, Vertex& vertex) {
  TwoFloat position[3];
  for (int c = 0; c < 3; ++c) {
    position[c] = morphed(draw, index, c);
    vertex.position[c] = position[c].high;
  }
  const std::array<Row, 4>&rows = draw.object_to_clip, &rest = draw.accuracy->clip_rest;
  vertex.clip = {
      two_float_row_times_point(rows[0], rest[0], position), two_float_row_times_point(rows[1], rest[1], position),
      two_float_row_times_point(rows[2], rest[2], position), two_float_row_times_point(rows[3], rest[3], position)};
}

}  // namespace morphcl::reference
