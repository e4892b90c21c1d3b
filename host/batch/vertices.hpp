// What transforms ask of their vertices.
#pragma once

#include "morphcl/batch.hpp"

namespace morphcl {

// Error(usage) unless both have the same layout and size, the outputs are apart from each other, and each output is
// apart from every input or is the same array.
template <class Real>
void check_in_and_out(const Vertices<const Real>& in, const Vertices<Real>& out);

}  // namespace morphcl
