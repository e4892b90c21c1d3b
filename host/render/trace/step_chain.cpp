#include "host/render/trace/step_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/math/finite.hpp"
#include "host/math/unit_roundoff.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr double u32 = unit_roundoff<float>, u64 = unit_roundoff<double>;
constexpr double slack = 1 + 0x1p-20;    // products of roundings
constexpr double min_single = 0x1p-149;  // what a rounding near 0 may be off by
constexpr double max_single = 0x1.fffffep+127;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_affine_row(const glm::dmat4& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

// The length of its column in place of each entry, but for the last row of an affine map, which is exact.
glm::dmat4 sizes_of(const glm::dmat4& matrix) {
  glm::dmat4 sizes;
  for (int column = 0; column < 4; ++column) {
    double largest = 0, sum = 0;
    for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
    for (int row = 0; row < 4; ++row) sum += largest > 0 ? std::abs(matrix[column][row]) / largest : 0;
    for (int row = 0; row < 4; ++row) sizes[column][row] = sum * largest;
  }
  if (is_affine_row(matrix))
    for (int column = 0; column < 4; ++column) sizes[column][3] = column == 3 ? 1 : 0;
  return sizes;
}

float to_single(double value) {
  if (std::abs(value) > max_single)
    return std::copysign(std::numeric_limits<float>::max(), static_cast<float>(value > 0 ? 1 : -1));
  return static_cast<float>(value);
}

// Not finite where fp32 overflows.
float row_in_single(const glm::dmat4& m, int row, const glm::vec4& p) {
  return std::fma(to_single(m[0][row]), p.x,
                  std::fma(to_single(m[1][row]), p.y, std::fma(to_single(m[2][row]), p.z, to_single(m[3][row]))));
}

}  // namespace

StepChain::StepChain(VectorForm written, const TracePoint& start) : form_(written), start_(start), point_(start) {}

glm::dmat4 StepChain::written(const glm::dmat4& matrix) const {
  return form_ == VectorForm::row ? glm::transpose(matrix) : matrix;
}

TraceStep StepChain::add(std::string name, std::string detail, const glm::dmat4& matrix,
                         const std::optional<glm::dmat4>& inverse) {
  composite_ = matrix * composite_;
  sizes_ = sizes_of(matrix) * sizes_;
  ++count_;
  point_ = apply();
  if (!is_finite(composite_) || !is_finite(point_.value))
    throw Error(ErrorKind::bad_input, name, "the point overflows in this step; use smaller numbers");
  TraceStep step;
  step.name = std::move(name);
  step.detail = std::move(detail);
  step.matrix = written(matrix);
  if (inverse) step.inverse = written(*inverse);
  step.composite = written(composite_);
  step.point = point_;
  return step;
}

TracePoint StepChain::apply() const {
  TracePoint after;
  const glm::dvec4& p = start_.value;
  constexpr double roundings[4] = {2, 3, 4, 4};
  for (int row = 0; row < 4; ++row) {
    double value = 0, single = 0, carried = 0, size = 0, magnitude = 0;
    for (int i = 4; i-- > 0;) {
      const double m = composite_[i][row];
      value = std::fma(m, p[i], value);
      single += roundings[i] * std::abs(m * p[i]);
      carried += std::abs(m) * start_.bound[i];
      magnitude += std::abs(m * p[i]) + std::abs(p[i]) + std::abs(m);
      size += sizes_[i][row] * std::abs(p[i]);
    }
    after.value[row] = value;
    if (row == 3 && is_affine_row(composite_)) {
      after.bound[row] = 0;
      after.single[row] = 1;
      continue;
    }
    after.bound[row] = (u32 * single + carried) * slack + 40 * (count_ + 1) * u64 * size +
                       min_single * (4 + std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
    if (!(magnitude * slack < max_single)) after.bound[row] = infinity;
    after.single[row] = row_in_single(composite_, row, start_.single);
  }
  return after;
}

std::optional<TracePoint> divided(const TracePoint& clip) {
  const double w = clip.value.w, error = clip.bound.w;
  if (!(w - error > 0)) return std::nullopt;
  TracePoint ndc;
  for (int i = 0; i < 3; ++i) {
    ndc.value[i] = clip.value[i] / w;
    const double size = std::abs(ndc.value[i]);
    const double carried = (clip.bound[i] + size * error) / (w - error);
    const bool exact = w == 1 && error == 0;
    ndc.bound[i] = exact ? clip.bound[i] : (carried + u32 * (size + carried)) * slack + 2 * min_single;
    ndc.single[i] = clip.single[i] / clip.single.w;
  }
  return ndc;
}

TracePoint scaled(const TracePoint& point, const glm::dvec3& scale, const glm::dvec3& shift) {
  TracePoint after = point;
  for (int i = 0; i < 3; ++i) {
    after.value[i] = std::fma(point.value[i], scale[i], shift[i]);
    const double carried = point.bound[i] * std::abs(scale[i]);
    const bool same = scale[i] == 1 && shift[i] == 0;
    after.bound[i] =
        same ? point.bound[i] : (carried + u32 * (std::abs(after.value[i]) + carried)) * slack + min_single;
    after.single[i] = std::fma(point.single[i], to_single(scale[i]), to_single(shift[i]));
  }
  return after;
}

}  // namespace morphcl
