// Matrices in the conventions of other systems and of textbooks. Inside morphcl there is one convention only: column
// vectors, right-handed eye space that is looked along -z, NDC depth from -1 at near to 1 at far.
//
// Every way there and back restores each bit. Transposing and changing signs lose nothing. Depth from 0 to 1 is half
// the sum of two rows, which rounds; what the rounding leaves out is kept beside the matrix (TwoSum, Knuth), and the
// way back adds it again. The exception are entries below 2^-1021, whose halves may underflow.
#pragma once

#include <glm/glm.hpp>

#pragma GCC visibility push(default)
namespace morphcl {

enum class VectorForm {
  column,  // p' = M p
  row,     // p' = p M, with the transposed matrix; products are written in the opposite order
};
enum class Handedness {
  right,  // looked along -z
  left,   // looked along +z: every z has the other sign, in the world and in eye space
};
enum class NdcDepth { minus_one_to_one, zero_to_one };

struct Convention {
  VectorForm vectors = VectorForm::column;
  Handedness handedness = Handedness::right;
  NdcDepth depth = NdcDepth::minus_one_to_one;
};

// The combinations that are met most; the last two are for depth from 0 to 1.
inline constexpr Convention column_right_handed{};              // morphcl's own; OpenGL
inline constexpr Convention row_right_handed{VectorForm::row};  // with the eye at (0, 0, d): see board_to_eye
inline constexpr Convention row_left_handed{VectorForm::row, Handedness::left};
inline constexpr Convention row_left_handed_zero_to_one{VectorForm::row, Handedness::left,
                                                        NdcDepth::zero_to_one};  // Direct3D
inline constexpr Convention column_right_handed_zero_to_one{VectorForm::column, Handedness::right,
                                                            NdcDepth::zero_to_one};

// `own` is morphcl's, `foreign` the other system's.

// Affine maps between spaces that both change: object to world, world to eye.
glm::dmat4 transform_to(const Convention& convention, const glm::dmat4& own);
glm::dmat4 transform_from(const Convention& convention, const glm::dmat4& foreign);

// Eye space to clip space.
struct ForeignProjection {
  glm::dmat4 matrix;
  glm::dvec4 depth_rest{0.0};  // by component of eye space: what rounding left out of the depth row; 0 for -1 to 1
};
ForeignProjection projection_to(const Convention& convention, const glm::dmat4& own);
glm::dmat4 projection_from(const Convention& convention, const ForeignProjection& foreign);

// From a drawing board's coordinates, with the board z = 0 and the eye at (0, 0, eye_z), to eye space.
glm::dmat4 board_to_eye(double eye_z);

}  // namespace morphcl
#pragma GCC visibility pop
