// The forms in which a draw's vertices can be computed, from the cheapest to the most accurate, and how far each may be
// off on the screen.
#pragma once

#include <array>

namespace morphcl {

// Row-major rows of an affine or projective map: row r gives component r = ((m[3] + z m[2]) + y m[1]) + x m[0] by fma.
using Row = std::array<float, 4>;

// plain      positions and matrix in fp32, the matrix composed in fp64 and rounded once
// pivot      the same from positions relative to a pivot: what lies far from its mesh's origin, or from the world's,
//            loses nothing by that
// two_float  positions, morph and matrix as sums of two floats; clip coordinates are rounded once
enum class VertexForm { plain, pivot, two_float };
constexpr std::array<VertexForm, 3> vertex_forms = {VertexForm::plain, VertexForm::pivot, VertexForm::two_float};

// Of a draw whose scene states an error.
struct VertexAccuracy {
  VertexForm form = VertexForm::plain;
  std::array<float, 3> pivot{};    // of the form: it is subtracted from positions, and the matrices take what is left
  std::array<Row, 4> clip_rest{};  // of two_float: what rounding took from object_to_clip
  std::array<double, 3> bounds{};  // pixels, of each form; infinity: none is known
  bool suffices = true;            // the form's bound is within the stated error
};

}  // namespace morphcl
