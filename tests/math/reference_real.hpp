// What the references in 168 bits are written with.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tests/math/reference.hpp"

namespace morphcl::reference {

using Real = boost::multiprecision::cpp_bin_float_50;
using Vector = std::array<Real, 3>;

inline Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Exact exact(const Real& value) {
  const auto high = static_cast<double>(value);
  return {high, static_cast<double>(Real(value - high))};
}

}  // namespace morphcl::reference
