#include "morphcl/convention.hpp"

#include "host/math/double_double.hpp"

namespace morphcl {

namespace {

// One by one: the minus of GLM's vectors is 0 - x, which makes +0 of both zeros.
void negate_column(glm::dmat4& m, int column) {
  for (int row = 0; row < 4; ++row) m[column][row] = -m[column][row];
}

void negate_row(glm::dmat4& m, int row) {
  for (int column = 0; column < 4; ++column) m[column][row] = -m[column][row];
}

}  // namespace

glm::dmat4 transform_to(const Convention& convention, const glm::dmat4& own) {
  glm::dmat4 m = own;
  if (convention.handedness == Handedness::left) {
    negate_column(m, 2);
    negate_row(m, 2);
  }
  return convention.vectors == VectorForm::row ? glm::transpose(m) : m;
}

glm::dmat4 transform_from(const Convention& convention, const glm::dmat4& foreign) {
  glm::dmat4 m = convention.vectors == VectorForm::row ? glm::transpose(foreign) : foreign;
  if (convention.handedness == Handedness::left) {
    negate_column(m, 2);
    negate_row(m, 2);
  }
  return m;
}

ForeignProjection projection_to(const Convention& convention, const glm::dmat4& own) {
  ForeignProjection result{own};
  glm::dmat4& m = result.matrix;
  if (convention.handedness == Handedness::left) negate_column(m, 2);
  if (convention.depth == NdcDepth::zero_to_one)
    for (int column = 0; column < 4; ++column) {
      const DoubleDouble sum = two_sum(m[column][2], m[column][3]);
      m[column][2] = 0.5 * sum.high;
      result.depth_rest[column] = 0.5 * sum.low;
    }
  if (convention.vectors == VectorForm::row) m = glm::transpose(m);
  return result;
}

glm::dmat4 projection_from(const Convention& convention, const ForeignProjection& foreign) {
  glm::dmat4 m = convention.vectors == VectorForm::row ? glm::transpose(foreign.matrix) : foreign.matrix;
  if (convention.depth == NdcDepth::zero_to_one)
    for (int column = 0; column < 4; ++column) {
      // z = (2h - w) + 2l. Where |w| >= |z| the difference is exact, else its error and 2l add up without rounding.
      const DoubleDouble difference = two_sum(2 * m[column][2], -m[column][3]);
      m[column][2] = difference.high + (difference.low + 2 * foreign.depth_rest[column]);
    }
  if (convention.handedness == Handedness::left) negate_column(m, 2);
  return m;
}

glm::dmat4 board_to_eye(double eye_z) {
  glm::dmat4 m(1.0);
  m[3][2] = -eye_z;
  return m;
}

}  // namespace morphcl
