// Comparisons that say which element is off, by how much, and what was allowed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>

#include "morphcl/error.hpp"
#include "tests/math/reference.hpp"

namespace morphcl {

// |computed - exact| <= bound.
inline testing::AssertionResult within(double computed, const reference::Exact& exact, double bound) {
  const double error = exact.error_of(computed);
  if (std::abs(error) <= bound) return testing::AssertionSuccess();
  return testing::AssertionFailure() << std::hexfloat << "expected " << exact.high << ", actual " << computed
                                     << std::defaultfloat << " (" << computed << "), error " << error << ", bound "
                                     << bound;
}

inline testing::AssertionResult within(double computed, double expected, double bound) {
  return within(computed, reference::Exact{expected, 0}, bound);
}

// Relative to the exact value's magnitude.
inline testing::AssertionResult within_relative(double computed, const reference::Exact& exact, double bound) {
  return within(computed, exact, bound * std::abs(exact.high));
}

// Rows and columns of the upper 3x3 against `linear`, the translation against `shift`.
inline void expect_affine(const glm::dmat4& computed, const reference::Affine& exact, double linear, double shift,
                          const std::string& what) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      EXPECT_TRUE(within(computed[column][row], exact[row][column], column < 3 ? linear : shift))
          << what << ": row " << row << ", column " << column;
}

inline void expect_point(const glm::dvec3& computed, const glm::dvec3& expected, double bound,
                         const std::string& what) {
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(within(computed[i], expected[i], bound)) << what << ": component "
                                                         << "xyz"[i];
}

inline glm::dvec3 transform_point(const glm::dmat4& m, const glm::dvec3& p) {
  const glm::dvec4 image = m * glm::dvec4(p, 1);
  return glm::dvec3(image) / image.w;
}

template <typename Action>
void expect_error(const Action& action, ErrorKind kind, const std::string& part) {
  try {
    action();
    ADD_FAILURE() << "no error; expected one with \"" << part << "\"";
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(kind)) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "expected \"" << part << "\" in: " << error.what();
  }
}

}  // namespace morphcl
