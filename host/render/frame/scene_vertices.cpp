#include "host/render/frame/scene_vertices.hpp"

#include <algorithm>
#include <cmath>

#include "host/render/frame/kernel_layout.hpp"
#include "host/render/frame/precise_vertices.hpp"

namespace morphcl::reference {

namespace {

// p <- fma(weight, target, fma(base_weight, base, p)) for each active target that has the attribute.
template <class Vector>
Vector morph(const Draw& draw, const std::vector<Vector>& base, std::vector<Vector> MorphTarget::* attribute,
             std::size_t i) {
  Vector value = base[i];
  for (const ActiveTarget& active : draw.targets) {
    const std::vector<Vector>& target = draw.mesh->targets[active.target].*attribute;
    if (target.empty()) continue;
    for (int c = 0; c < Vector::length(); ++c)
      value[c] = std::fma(active.weight, target[i][c], std::fma(active.base_weight, base[i][c], value[c]));
  }
  return value;
}

glm::vec3 object_position(const Draw& draw, std::size_t i) {
  return draw.displaced ? draw.displaced->positions[i] : morph(draw, draw.mesh->positions, &MorphTarget::positions, i);
}

// The morphed position, in the draw's own form, and its clip coordinates.
void set_clip_point(const Draw& draw, std::size_t i, Vertex& v) {
  const VertexForm form = draw.accuracy ? draw.accuracy->form : VertexForm::plain;
  if (form == VertexForm::two_float) {
    set_two_float_clip_point(draw, i, v);
    return;
  }
  v.position = form == VertexForm::pivot ? pivot_position(draw, i) : object_position(draw, i);
  v.clip = {row_times_point(draw.object_to_clip[0], v.position), row_times_point(draw.object_to_clip[1], v.position),
            row_times_point(draw.object_to_clip[2], v.position), row_times_point(draw.object_to_clip[3], v.position)};
}

int outcode(const ClipPoint& p, const FramePlan& plan, const RasterGrid& grid) {
  const float limit_x = p.w * grid.guard_x, limit_y = p.w * grid.guard_y;
  int code = 0;
  if (!(near_distance(p.z, p.w, plan) >= 0.0f)) code |= OUT_NEAR;
  if (!(p.x >= -limit_x)) code |= OUT_LEFT;
  if (!(p.x <= limit_x)) code |= OUT_RIGHT;
  if (!(p.y <= limit_y)) code |= OUT_TOP;
  if (!(p.y >= -limit_y)) code |= OUT_BOTTOM;
  for (const float v : {p.x, p.y, p.z, p.w})
    if (!(std::fabs(v) <= MAX_CLIP_COORDINATE)) code |= OUT_INVALID;
  return code;
}

struct SnappedCoordinate {
  int subpixel, rest;
};

// round(v / w * scale + offset), ties to even, with the rounding errors of quotient, product and sum carried along; and
// what rounding took away, in corner units.
SnappedCoordinate snap(float v, float w, float scale, float offset) {
  const float quotient = v / w;
  const float quotient_rest = std::fma(-quotient, w, v) / w;
  const float product = quotient * scale;
  const float product_rest = std::fma(quotient_rest, scale, std::fma(quotient, scale, -product));
  const float sum = product + offset;
  const float offset_part = sum - product;
  const float sum_rest = (product - (sum - offset_part)) + (offset - offset_part);
  const float whole = std::nearbyint(sum);
  const float rest = (sum - whole) + (sum_rest + product_rest);
  const float step = std::nearbyint(rest);
  const int units = static_cast<int>(std::nearbyint((rest - step) * static_cast<float>(layout::corner_units)));
  return {static_cast<int>(whole) + static_cast<int>(step), std::min(units, layout::corner_units / 2 - 1)};
}

glm::vec3 eye_normal(const Draw& draw, std::size_t i) {
  const glm::vec3& base = draw.mesh->normals[i];
  glm::vec3 n = morph(draw, draw.mesh->normals, &MorphTarget::normals, i);
  if (!(std::fma(n.x, n.x, std::fma(n.y, n.y, n.z * n.z)) >= 0x1p-20f)) n = base;
  glm::vec3 eye;
  for (int row = 0; row < 3; ++row) eye[row] = row_times_vector(draw.normal_to_eye[row], n);
  const float length = std::sqrt(std::fma(eye.x, eye.x, std::fma(eye.y, eye.y, eye.z * eye.z)));
  const float divisor = length > 0.0f ? length : 1.0f;
  return {eye.x / divisor, eye.y / divisor, eye.z / divisor};
}

}  // namespace

float row_times_point(const Row& row, const glm::vec3& p) {
  return std::fma(row[0], p.x, std::fma(row[1], p.y, std::fma(row[2], p.z, row[3])));
}

float row_times_vector(const std::array<float, 3>& row, const glm::vec3& v) {
  return std::fma(row[0], v.x, std::fma(row[1], v.y, row[2] * v.z));
}

float near_distance(float z, float w, const FramePlan& plan) {
  return std::fma(plan.camera.near_plane[0], z, std::fma(plan.camera.near_plane[1], w, plan.camera.near_plane[2]));
}

ScreenVertex to_screen(const ClipPoint& p, const RasterGrid& grid) {
  const float inverse_w = 1.0f / p.w;
  const SnappedCoordinate x = snap(p.x, p.w, grid.scale_x, grid.offset_x),
                          y = snap(p.y, p.w, grid.scale_y, grid.offset_y);
  return {x.subpixel, y.subpixel, p.z * inverse_w, inverse_w, x.rest, y.rest};
}

ScreenVertex to_screen(const ClipPoint& p, const RasterGrid& grid, const FramePlan& plan) {
  ScreenVertex vertex = to_screen(p, grid);
  if (is_forward(plan.depth_format)) vertex.depth = plan.camera.parallel ? -p.z : p.w;
  return vertex;
}

std::vector<Vertex> project_vertices(const Draw& draw, const FramePlan& plan, const RasterGrid& grid) {
  const Mesh& mesh = *draw.mesh;
  std::vector<Vertex> vertices(mesh.positions.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Vertex& v = vertices[i];
    set_clip_point(draw, i, v);
    v.outcode = outcode(v.clip, plan, grid);
    if (v.outcode == 0) v.screen = to_screen(v.clip, grid, plan);
    if (draw.shading == Shading::smooth || draw.normals == NormalSource::vertices) v.normal = eye_normal(draw, i);
    if (draw.vertex_colors) {
      v.color = morph(draw, mesh.colors, &MorphTarget::colors, i);
      for (int c = 0; c < 4; ++c) v.color[c] = std::min(std::max(v.color[c], 0.0f), 1.0f) + 0.0f;
    }
  }
  return vertices;
}

}  // namespace morphcl::reference
