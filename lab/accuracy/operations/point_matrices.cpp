#include "lab/accuracy/operations/point_matrices.hpp"

#include <cmath>
#include <glm/glm.hpp>

#include "morphcl/transform.hpp"

namespace morphcl::accuracy {

namespace {

glm::mat4 translation32(const glm::vec3& offset) {
  glm::mat4 m(1.0f);
  m[3] = glm::vec4(offset, 1.0f);
  return m;
}

glm::mat4 rodrigues32(glm::vec3 n, float radians) {
  n /= std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  const float c = std::cos(radians), s = std::sin(radians), v = 1 - c;
  glm::mat4 m(1.0f);
  m[0] = {c + v * n.x * n.x, v * n.x * n.y + s * n.z, v * n.x * n.z - s * n.y, 0};
  m[1] = {v * n.x * n.y - s * n.z, c + v * n.y * n.y, v * n.y * n.z + s * n.x, 0};
  m[2] = {v * n.x * n.z + s * n.y, v * n.y * n.z - s * n.x, c + v * n.z * n.z, 0};
  return m;
}

template <class To, class From>
std::array<std::array<To, 4>, 3> mapped(const std::array<std::array<From, 4>, 3>& rows, auto convert) {
  std::array<std::array<To, 4>, 3> result;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) result[row][column] = convert(rows[row][column]);
  return result;
}

}  // namespace

Rows64 composed_in_fp64(const Batch& batch) {
  const glm::dvec3 pivot(batch.constants[0], batch.constants[1], batch.constants[2]);
  const glm::dvec3 axis(pivot_axis[0], pivot_axis[1], pivot_axis[2]);
  const glm::dmat4 m = CompositeTransform().rotate_about_axis(pivot, pivot + axis, pivot_degrees).matrix();
  Rows64 rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) rows[row][column] = m[column][row];
  return rows;
}

Rows32 composed_in_fp32(const Batch& batch) {
  const glm::vec3 pivot(batch.constants[0], batch.constants[1], batch.constants[2]);
  const glm::vec3 axis(pivot_axis[0], pivot_axis[1], pivot_axis[2]);
  const float angle = static_cast<float>(pivot_degrees) * 3.14159265f / 180;
  const glm::mat4 m = translation32(pivot) * rodrigues32(axis, angle) * translation32(-pivot);
  Rows32 rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) rows[row][column] = m[column][row];
  return rows;
}

Rows32 rounded(const Rows64& rows) {
  return mapped<float>(rows, [](double value) { return static_cast<float>(value); });
}

Rows64 widened(const Rows32& rows) {
  return mapped<double>(rows, [](float value) { return static_cast<double>(value); });
}

Rows64 rest_of(const Rows64& rows) {
  return mapped<double>(rows, [](double value) { return value - static_cast<double>(static_cast<float>(value)); });
}

std::array<float, 3> pivot32(const Batch& batch) {
  return {static_cast<float>(batch.constants[0]), static_cast<float>(batch.constants[1]),
          static_cast<float>(batch.constants[2])};
}

}  // namespace morphcl::accuracy
