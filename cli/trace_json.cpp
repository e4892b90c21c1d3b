#include "cli/trace_json.hpp"

#include "cli/console.hpp"
#include "cli/json_object.hpp"
#include "cli/trace_words.hpp"

namespace morphcl::cli {

namespace {

template <class Vector>
Json array_of(const Vector& vector) {
  Json array = Json::array();
  for (int i = 0; i < Vector::length(); ++i) array.push_back(vector[i]);
  return array;
}

Json rows_of(const glm::dmat4& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    Json numbers = Json::array();
    for (int column = 0; column < 4; ++column) numbers.push_back(entry(matrix, row, column));
    rows.push_back(numbers);
  }
  return rows;
}

Json rows_of(const glm::dmat3& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row]});
  return rows;
}

Json rows_of(const std::optional<glm::dmat4>& matrix) { return matrix ? rows_of(*matrix) : Json(nullptr); }

void put_point(const TracePoint& point, Json& fields) {
  fields["point"] = array_of(point.value);
  fields["bound"] = array_of(point.bound);
  fields["fp32"] = array_of(point.single);
}

void json_morph_target(const TraceTarget& target) {
  print_result(
      line_of(json_object("trace_target", {{"name", target.name},
                                           {"form", target.form == TargetForm::absolute ? "absolute" : "delta"},
                                           {"weight", target.weight},
                                           {"value", array_of(target.value)},
                                           {"after", array_of(target.after)}})));
}

void json_steps(const TraceStage& stage, const std::vector<TraceStep>& steps, const std::string& number) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const TraceStep& step = steps[i];
    const std::string name = number + std::to_string(i + 1);
    Json fields = {{"from", name_of(stage.from)},
                   {"to", name_of(stage.to)},
                   {"step", name},
                   {"name", step.name},
                   {"detail", step.detail},
                   {"matrix", rows_of(step.matrix)},
                   {"inverse", rows_of(step.inverse)},
                   {"composite", rows_of(step.composite)}};
    put_point(step.point, fields);
    print_result(line_of(json_object("trace_step", fields)));
    json_steps(stage, step.parts, name + ".");
  }
}

void json_stage(const TraceStage& stage) {
  if (!stage.divides) json_steps(stage, stage.steps, "");
  Json fields = {
      {"from", name_of(stage.from)}, {"to", name_of(stage.to)}, {"what", stage.what}, {"divides", stage.divides}};
  if (!stage.divides) {
    fields["matrix"] = rows_of(stage.matrix);
    fields["inverse"] = rows_of(stage.inverse);
  }
  fields["composite"] = rows_of(stage.composite);
  fields["before"] = array_of(stage.before.value);
  put_point(stage.after, fields);
  print_result(line_of(json_object("trace_stage", fields)));
}

}  // namespace

void print_trace_json(const Trace& trace) {
  Json fields = {{"frame", trace.frame},
                 {"object", trace.object},
                 {"mesh", trace.mesh},
                 {"vertices", trace.vertices},
                 {"vertex", trace.vertex ? Json(*trace.vertex) : Json(nullptr)},
                 {"width", trace.width},
                 {"height", trace.height},
                 {"vectors", vectors_name(trace.convention)},
                 {"handedness", handedness_name(trace.convention)},
                 {"ndc_depth", depth_name(trace.convention)},
                 {"base", array_of(trace.base)}};
  put_point(trace.start, fields);
  print_result(line_of(json_object("trace", fields)));
  for (const TraceTarget& target : trace.targets) json_morph_target(target);
  for (const TraceStage& stage : trace.stages) json_stage(stage);
  if (trace.plane)
    for (const TracePlaneStep& step : trace.plane->steps)
      print_result(line_of(json_object("trace_plane", {{"axes", trace.plane->axes},
                                                       {"start", array_of(trace.plane->start)},
                                                       {"name", step.name},
                                                       {"detail", step.detail},
                                                       {"matrix", rows_of(step.matrix)},
                                                       {"inverse", rows_of(step.inverse)},
                                                       {"composite", rows_of(step.composite)},
                                                       {"point", array_of(step.point)}})));
  Json end = {{"pixel", trace.pixel ? array_of(*trace.pixel) : Json(nullptr)},
              {"distance", trace.distance ? Json(*trace.distance) : Json(nullptr)},
              {"notes", trace.notes}};
  if (trace.rendered) {
    end["rendered_xyw"] = array_of(trace.rendered->clip);
    end["rendered_subpixel"] = array_of(trace.rendered->subpixel);
  }
  print_result(line_of(json_object("trace_end", end)));
}

void print_pixel_json(const PixelTrace& trace) {
  Json corners = Json::array();
  for (const TraceCorner& corner : trace.corners)
    corners.push_back({{"vertex", corner.vertex},
                       {"position", array_of(corner.position)},
                       {"clip", array_of(corner.clip)},
                       {"distance", corner.distance},
                       {"picture_weight", corner.picture_weight},
                       {"weight", corner.weight}});
  print_result(line_of(json_object("trace_pixel", {{"frame", trace.forward.frame},
                                                   {"pixel", array_of(trace.pixel)},
                                                   {"centre", array_of(trace.centre)},
                                                   {"ndc", array_of(trace.ndc)},
                                                   {"eye_from", array_of(trace.eye_from)},
                                                   {"eye_along", array_of(trace.eye_along)},
                                                   {"world_from", array_of(trace.world_from)},
                                                   {"world_along", array_of(trace.world_along)},
                                                   {"object", trace.object},
                                                   {"mesh", trace.mesh},
                                                   {"kind", trace.line ? "edge" : "triangle"},
                                                   {"primitive", trace.primitive},
                                                   {"corners", corners},
                                                   {"parallel", trace.parallel},
                                                   {"depth_a", trace.depth_a},
                                                   {"depth_b", trace.depth_b},
                                                   {"in_object", array_of(trace.in_object)},
                                                   {"in_world", array_of(trace.in_world)},
                                                   {"in_eye", array_of(trace.in_eye)},
                                                   {"distance", trace.distance},
                                                   {"ndc_depth", trace.ndc_depth},
                                                   {"mean_distance", trace.mean_distance},
                                                   {"mean_depth", trace.mean_depth},
                                                   {"rendered_distance", trace.rendered_distance}})));
  print_trace_json(trace.forward);
}

}  // namespace morphcl::cli
