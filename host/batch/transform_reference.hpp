// The batch transforms in plain loops on the host: the contract and the bits of transform_vertices.hpp.
#pragma once

#include <type_traits>

#include "host/batch/transform.hpp"
#include "host/batch/vertices.hpp"

namespace morphcl {

// `out` may be the same arrays as `in`. A vertex that asks for a matrix past the last one becomes NaN. Error(usage) as
// check_in_and_out() and check_choice().
template <class Real>
void transform_reference(const Transform<Real>& transform, const Vertices<const std::type_identity_t<Real>>& in,
                         const Vertices<std::type_identity_t<Real>>& out,
                         const MatrixChoice<std::type_identity_t<Real>>& choice = {});

}  // namespace morphcl
