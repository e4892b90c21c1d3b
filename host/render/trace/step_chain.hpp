// Matrices that a point meets one after the other: their composite, the point after them, and how far fp32 may be off.
// trace.hpp derives the bound.
#pragma once

#include <optional>
#include <string>

#include "morphcl/trace.hpp"

namespace morphcl {

// Within: column vectors, in the handedness and depth of the caller's convention. What it gives out is as
// `written` says.
class StepChain {
 public:
  // `start` in the caller's handedness; its bound is the error that fp32 starts with.
  StepChain(VectorForm written, const TracePoint& start);

  TraceStep add(std::string name, std::string detail, const glm::dmat4& matrix,
                const std::optional<glm::dmat4>& inverse);

  glm::dmat4 composite() const { return written(composite_); }
  glm::dmat4 written(const glm::dmat4& matrix) const;
  const TracePoint& point() const { return point_; }

 private:
  TracePoint apply() const;

  VectorForm form_;
  TracePoint start_, point_;
  glm::dmat4 composite_{1.0}, sizes_{1.0};
  int count_ = 0;
};

// (x / w, y / w, z / w, 1). Nothing where w is not positive by more than its bound.
std::optional<TracePoint> divided(const TracePoint& clip);

// An affine map of scales and shifts that fp32 holds exactly, by one fma each.
TracePoint scaled(const TracePoint& point, const glm::dvec3& scale, const glm::dvec3& shift);

}  // namespace morphcl
