#include "cli/trace_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace morphcl::cli {

std::string short_number(double value) { return fmt::format("{:.6g}", value + 0.0); }

std::string point_words(const glm::dvec3& point) {
  return fmt::format("({}, {}, {})", short_number(point.x), short_number(point.y), short_number(point.z));
}

std::string vectors_name(const Convention& convention) {
  return convention.vectors == VectorForm::row ? "row" : "column";
}

std::string handedness_name(const Convention& convention) {
  return convention.handedness == Handedness::left ? "left" : "right";
}

std::string depth_name(const Convention& convention) {
  return convention.depth == NdcDepth::zero_to_one ? "zero_to_one" : "minus_one_to_one";
}

std::string subject(const Trace& trace) {
  if (trace.vertex) return fmt::format("vertex {} of \"{}\"", *trace.vertex, trace.object);
  return fmt::format("point {} of \"{}\"", point_words(trace.base), trace.object);
}

}  // namespace morphcl::cli
