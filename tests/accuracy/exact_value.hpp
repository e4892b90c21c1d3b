// The reference's answers as numbers of the catalogue.
#pragma once

#include "tests/accuracy/demand.hpp"
#include "tests/math/reference.hpp"

namespace morphcl::accuracy {

inline Real exact(const reference::Exact& value) { return Real(value.high) + Real(value.low); }

}  // namespace morphcl::accuracy
