#include "host/render/trace/morphed_point.hpp"

#include <cmath>

#include "host/math/unit_roundoff.hpp"

namespace morphcl {

namespace {

constexpr double morph_u32 = unit_roundoff<float>, morph_u64 = unit_roundoff<double>;

// One component, one target after the other.
struct Component {
  double value, error = 0, size;
  float single;

  explicit Component(float base) : value(base), size(std::abs(value)), single(base) {}

  void apply(double weight, float base, float target, bool absolute) {
    const auto w = static_cast<float>(weight);
    const double moved = std::abs(weight * target), replaced = absolute ? std::abs(weight * base) : 0;
    const double inner = std::abs(value) + error + replaced;
    error += morph_u32 * (replaced + (absolute ? inner : 0) + moved + (inner + moved) * (1 + 0x1p-20));
    size += moved + replaced;
    value = absolute ? std::fma(weight, target, std::fma(-weight, base, value)) : std::fma(weight, target, value);
    single = std::fma(w, target, std::fma(absolute ? -w : 0.0f, base, single));
  }

  double bound(std::size_t targets) const {
    const auto n = static_cast<double>(targets);
    return error * (1 + 0x1p-20) + 4 * n * morph_u64 * size + 3 * n * 0x1p-149;
  }
};

}  // namespace

void morph_point(const Mesh& mesh, std::size_t vertex, const std::vector<double>& weights, Trace& trace) {
  const glm::vec3& base = mesh.positions[vertex];
  trace.base = base;
  Component part[3] = {Component(base.x), Component(base.y), Component(base.z)};
  for (std::size_t t = 0; t < weights.size(); ++t) {
    const MorphTarget& target = mesh.targets[t];
    if (target.positions.empty()) continue;
    TraceTarget moved{target.name, target.form, weights[t], target.positions[vertex], {}};
    for (int c = 0; c < 3; ++c) {
      part[c].apply(weights[t], base[c], target.positions[vertex][c], target.form == TargetForm::absolute);
      moved.after[c] = part[c].value;
    }
    trace.targets.push_back(std::move(moved));
  }
  for (int c = 0; c < 3; ++c) {
    trace.start.value[c] = part[c].value;
    trace.start.single[c] = part[c].single;
    trace.start.bound[c] = trace.targets.empty() ? 0 : part[c].bound(trace.targets.size());
  }
}

TracePoint start_at(const glm::dvec3& point) {
  TracePoint start;
  for (int c = 0; c < 3; ++c) {
    start.value[c] = point[c];
    start.single[c] = static_cast<float>(point[c]);
    start.bound[c] = std::abs(point[c] - start.single[c]);
  }
  return start;
}

}  // namespace morphcl
