// What transforms ask of the choice among their matrices.
#pragma once

#include "morphcl/batch.hpp"

namespace morphcl {

// Error(usage) where there is no choice among several matrices, or a blend of normals.
template <class Real>
void check_choice_kind(const Transform<Real>& transform, bool chosen, bool blended);

// The same, and Error(usage) where the choice is for another number of vertices than `count`.
template <class Real>
void check_choice(const Transform<Real>& transform, const MatrixChoice<Real>& choice, std::size_t count);

// Error(usage) naming the first vertex that asks for a matrix past the last one, if any does.
template <class Real>
void check_indices(const Transform<Real>& transform, const MatrixChoice<Real>& choice);

// The choices of vertices `first` to `first + count - 1`.
template <class Real>
MatrixChoice<Real> part(const MatrixChoice<Real>& choice, std::size_t first, std::size_t count);

}  // namespace morphcl
