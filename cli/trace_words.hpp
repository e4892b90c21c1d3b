// What the ways of printing a trace share: conventions and spaces in words, short numbers.
#pragma once

#include <string>

#include "morphcl/trace.hpp"

namespace morphcl::cli {

std::string short_number(double value);  // six digits; "inf" where there is none
std::string point_words(const glm::dvec3& point);
std::string vectors_name(const Convention& convention);     // "column"
std::string handedness_name(const Convention& convention);  // "right"
std::string depth_name(const Convention& convention);       // "minus_one_to_one"
std::string subject(const Trace& trace);                    // "vertex 3 of \"solid\""
// Entry of a matrix as it is written, whatever its convention.
inline double entry(const glm::dmat4& matrix, int row, int column) { return matrix[column][row]; }

}  // namespace morphcl::cli
