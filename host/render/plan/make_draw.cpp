#include "host/render/plan/make_draw.hpp"

#include <algorithm>

#include "host/render/frame/kernel_layout.hpp"
#include "host/render/plan/transparency.hpp"
#include "host/scene/model/base_color.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

Row to_row(const glm::dmat4& m, int row) {
  return {to_fp32(m[0][row]), to_fp32(m[1][row]), to_fp32(m[2][row]), to_fp32(m[3][row])};
}

bool is_lit(Shading shading) { return shading == Shading::smooth || shading == Shading::flat; }

// As shading has them, and unlit the mesh's own if it has any.
NormalSource normals_shown_by(Shading shading, const Mesh& mesh) {
  if (shading == Shading::wireframe) return NormalSource::none;
  return shading == Shading::flat || mesh.normals.empty() ? NormalSource::faces : NormalSource::vertices;
}

}  // namespace

void make_draw(const DrawContext& context, std::size_t object_index, const glm::dmat4& object_to_eye,
               const glm::dmat4& object_to_clip, Draw& draw) {
  const Object& object = context.scene.objects[object_index];
  draw.mesh = &context.scene.meshes[object.mesh];
  draw.object = static_cast<std::uint32_t>(object_index);
  context.ids.set(object_index, draw);
  draw.double_sided = object.material.double_sided;
  draw.mirrored = glm::determinant(glm::dmat3(object_to_eye)) < 0.0;
  const glm::dvec4 base = base_color_at(object.material, context.tick);
  draw.base_color = {to_fp32(base.r), to_fp32(base.g), to_fp32(base.b), to_fp32(base.a)};

  draw.line_width = static_cast<std::uint32_t>(std::max(1.0, object.material.line_width * layout::subpixels + 0.5));

  draw.shading = object.material.shading;
  draw.vertex_colors = draw.shading != Shading::wireframe && !draw.mesh->colors.empty();
  draw.blended = transparency_of(object.material, base.a, context.vertex_alpha[object.mesh], context.plan.channels) ==
                 Transparency::some;
  const bool masked = draw.blended && object.material.alpha_mode == AlphaMode::mask;
  draw.alpha_cutoff = masked ? to_fp32(std::clamp(object.material.alpha_cutoff, 0.0, 2.0)) : -1.0f;
  const bool shows_albedo = context.plan.has(Channel::albedo), shows_normals = context.plan.has(Channel::normal);
  draw.albedo = {};
  if (shows_albedo) std::copy_n(draw.base_color.begin(), 3, draw.albedo.begin());
  draw.normals = shows_normals ? normals_shown_by(draw.shading, *draw.mesh) : NormalSource::none;
  draw.lit_per_pixel = false;
  if (draw.shading == Shading::smooth && draw.mesh->normals.empty()) {
    // The face has one normal. Light from a direction gives it one colour; a point light does not.
    const auto is_point = [](const EyeLight& light) { return light.kind == LightKind::point; };
    draw.shading = Shading::flat;
    draw.lit_per_pixel = std::any_of(context.plan.lights.begin(), context.plan.lights.end(), is_point);
  }
  if (!context.plan.has_color() && !context.keeps_normals) {
    // Distances do not depend on colours.
    if (draw.shading != Shading::wireframe) draw.shading = Shading::unlit;
    draw.vertex_colors = draw.vertex_colors && (shows_albedo || draw.blended);
  } else if (context.plan.lights.empty() && is_lit(draw.shading) && !context.keeps_normals) {
    // Without lights every normal gives the ambient light, which goes into the base colour: the same fp32 product.
    draw.shading = Shading::unlit;
    for (int i = 0; i < 3; ++i) draw.base_color[i] = draw.base_color[i] * context.plan.ambient[i];
  }

  if (draw.shading != Shading::flat) draw.lit_per_pixel = false;

  for (int row = 0; row < 4; ++row) draw.object_to_clip[row] = to_row(object_to_clip, row);
  for (int row = 0; row < 3; ++row) draw.object_to_eye[row] = to_row(object_to_eye, row);
  if (is_lit(draw.shading) || draw.normals != NormalSource::none || context.keeps_normals) {
    const glm::dmat3 normals = normal_matrix(object_to_eye);
    for (int row = 0; row < 3; ++row)
      draw.normal_to_eye[row] = {to_fp32(normals[0][row]), to_fp32(normals[1][row]), to_fp32(normals[2][row])};
  }
}

// A target whose weight is 0 adds 0 to every vertex, fma(0, target, fma(-0, base, p)) = p, so it is left out.
void set_targets(const std::vector<double>& weights, bool keeps_idle, Draw& draw) {
  draw.targets.clear();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const float weight = to_fp32(weights[i]);
    if (weight == 0.0f && !keeps_idle) continue;
    const bool absolute = draw.mesh->targets[i].form == TargetForm::absolute;
    draw.targets.push_back({static_cast<int>(i), weight, absolute ? -weight : 0.0f});
  }
}

}  // namespace morphcl
