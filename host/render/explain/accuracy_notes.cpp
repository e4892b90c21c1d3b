#include "host/render/explain/accuracy_notes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace morphcl {

namespace {

constexpr std::size_t max_notes = 16;

std::string_view name_of(VertexForm form) {
  constexpr std::array<std::string_view, 3> names = {"fp32", "fp32 relative to a pivot", "two floats"};
  return names[static_cast<std::size_t>(form)];
}

std::string pixels(double bound) { return std::isfinite(bound) ? fmt::format("{:.2g}", bound) : "any number of"; }

std::string reason(const VertexAccuracy& accuracy, double stated) {
  const auto form = static_cast<std::size_t>(accuracy.form);
  std::string text = fmt::format("{}: at most {} pixels off", name_of(accuracy.form), pixels(accuracy.bounds[form]));
  if (!accuracy.suffices) return text + fmt::format("; warning: no form is known to keep {} pixels", stated);
  if (form > 0)
    text += fmt::format("; {} may be {} off", name_of(vertex_forms[form - 1]), pixels(accuracy.bounds[form - 1]));
  return text;
}

double milliseconds(const Draw& draw, const CostModel& model) {
  const double more[] = {0, model.pivot_vertex, model.two_float_vertex};
  return 1e-6 * static_cast<double>(draw.mesh->positions.size()) *
         (model.vertex + more[static_cast<std::size_t>(draw.accuracy->form)]);
}

}  // namespace

std::vector<PlanNote> accuracy_notes(const Scene& scene, const FramePlan& plan, const CostModel& model) {
  std::vector<PlanNote> notes;
  if (!(scene.accuracy_pixels > 0)) return notes;
  std::array<std::size_t, 3> rest{};
  std::size_t missed = 0, unbounded = 0;
  PlanNote others;
  for (const Draw& draw : plan.draws) {
    const std::string item = fmt::format("vertices of \"{}\"", scene.objects[draw.object].name);
    const bool room = notes.size() < max_notes;
    if (!draw.accuracy) {
      if (room)
        notes.push_back({item, true, "fp32, without a bound: it moves on springs", 0});
      else
        ++unbounded;
      continue;
    }
    if (room) {
      notes.push_back({item, true, reason(*draw.accuracy, scene.accuracy_pixels), milliseconds(draw, model)});
      continue;
    }
    ++rest[static_cast<std::size_t>(draw.accuracy->form)];
    missed += !draw.accuracy->suffices;
    others.milliseconds += milliseconds(draw, model);
  }
  if (rest == std::array<std::size_t, 3>{} && unbounded == 0) return notes;
  others.item = "vertices of the others";
  others.done = true;
  for (const VertexForm form : vertex_forms)
    if (const std::size_t count = rest[static_cast<std::size_t>(form)])
      others.reason += fmt::format("{}{} in {}", others.reason.empty() ? "" : ", ", count, name_of(form));
  if (unbounded)
    others.reason += fmt::format("{}{} in fp32 without a bound", others.reason.empty() ? "" : ", ", unbounded);
  if (missed) others.reason += fmt::format("; warning: {} may be off by more than stated", missed);
  notes.push_back(std::move(others));
  return notes;
}

}  // namespace morphcl
