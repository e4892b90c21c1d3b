#include "host/render/plan/choose_vertex_form.hpp"

#include <algorithm>

#include "host/render/frame/raster_grid.hpp"
#include "host/render/plan/vertex_bounds.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

glm::dmat4 absolute(const glm::dmat4& m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]), glm::abs(m[3])}; }

int moving_targets(const Draw& draw) {
  return static_cast<int>(std::count_if(draw.targets.begin(), draw.targets.end(), [&](const ActiveTarget& active) {
    return active.weight != 0.0f && !draw.mesh->targets[active.target].positions.empty();
  }));
}

// Rows of a matrix for points relative to the pivot.
template <std::size_t rows>
void recentre(const glm::dmat4& matrix, const glm::dvec3& pivot, std::array<Row, rows>& out) {
  const glm::dvec4 constant = matrix * glm::dvec4(pivot, 1.0);
  for (std::size_t r = 0; r < rows; ++r) out[r][3] = to_fp32(constant[static_cast<int>(r)]);
}

float rest_of(double value, float rounded) { return static_cast<float>(value - double{rounded}); }

void split(const glm::dmat4& matrix, const std::array<Row, 4>& rounded, std::array<Row, 4>& rest) {
  for (int r = 0; r < 4; ++r)
    for (int column = 0; column < 4; ++column) rest[r][column] = rest_of(matrix[column][r], rounded[r][column]);
}

VertexForm cheapest(const std::array<double, 3>& bounds, double pixels, bool& suffices) {
  VertexForm best = VertexForm::two_float;
  for (const VertexForm form : vertex_forms) {
    const double bound = bounds[static_cast<std::size_t>(form)];
    suffices = bound <= pixels;
    if (suffices) return form;
    if (bound < bounds[static_cast<std::size_t>(best)]) best = form;
  }
  return best;
}

}  // namespace

void choose_vertex_form(const VertexSetting& setting, const FramePlan& plan, Draw& draw) {
  const glm::dmat4 object_to_eye = setting.world_to_eye * setting.object_to_world;
  const glm::dmat4 object_to_clip = setting.eye_to_clip * object_to_eye;
  const RasterGrid grid(plan.width, plan.height);
  VertexTerms terms;
  terms.object_to_clip = object_to_clip;
  terms.magnitudes = absolute(setting.eye_to_clip) * absolute(setting.world_to_eye) * absolute(setting.object_to_world);
  terms.box = setting.mesh.at(setting.weights);
  const glm::vec3 pivot = to_fp32(terms.box.center());
  terms.pivot = pivot;
  terms.plain_terms = setting.mesh.terms(setting.weights, glm::dvec3(0.0));
  terms.pivot_terms = setting.mesh.terms(setting.weights, terms.pivot);
  terms.targets = moving_targets(draw);

  VertexAccuracy accuracy;
  accuracy.bounds =
      vertex_error_bounds(terms, {plan.width, plan.height, grid.guard_x, grid.guard_y, plan.camera.near_w});
  accuracy.form = cheapest(accuracy.bounds, setting.pixels, accuracy.suffices);
  if (accuracy.form == VertexForm::pivot) {
    accuracy.pivot = {pivot.x, pivot.y, pivot.z};
    recentre(object_to_clip, terms.pivot, draw.object_to_clip);
    recentre(object_to_eye, terms.pivot, draw.object_to_eye);
  }
  if (accuracy.form == VertexForm::two_float) {
    split(object_to_clip, draw.object_to_clip, accuracy.clip_rest);
    ActiveTargets targets;
    for (ActiveTarget active : draw.targets) {
      active.weight_rest = rest_of(setting.weights[active.target], active.weight);
      targets.push_back(active);
    }
    draw.targets = std::move(targets);
  }
  draw.accuracy = std::make_shared<const VertexAccuracy>(accuracy);
}

}  // namespace morphcl
