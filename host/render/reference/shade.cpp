#include "host/render/reference/shade.hpp"

#include <cmath>

#include "host/render/frame/raster_grid.hpp"
#include "host/render/reference/light.hpp"

namespace morphcl::reference {

namespace {

struct Weights {
  float vertex[3];
  float distance = 0;  // of the pixel, interpolated like an attribute
  float total() const { return vertex[0] + vertex[1] + vertex[2]; }
};

Weights screen_weights(const FramePlan& plan, const ScreenVertex corner[3], int x, int y) {
  float dx[3], dy[3];
  for (int i = 0; i < 3; ++i) {
    dx[i] = static_cast<float>(corner[i].x - pixel_centre(x));
    dy[i] = static_cast<float>(corner[i].y - pixel_centre(y));
  }
  Weights w;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    w.vertex[i] = difference_of_products(dx[j], dy[k], dx[k], dy[j]);
    if (!plan.camera.parallel) w.vertex[i] *= corner[i].inverse_w;
  }
  if (is_forward(plan.depth_format))  // its corners have their distance in place of depth
    w.distance =
        std::fma(w.vertex[0], corner[0].depth, std::fma(w.vertex[1], corner[1].depth, w.vertex[2] * corner[2].depth)) /
        w.total();
  return w;
}

Weights source_weights(const Weights& cut, const Piece& piece) {
  Weights w;
  w.distance = cut.distance;
  for (int i = 0; i < 3; ++i)
    w.vertex[i] = std::fma(cut.vertex[0], piece.weight[0][i],
                           std::fma(cut.vertex[1], piece.weight[1][i], cut.vertex[2] * piece.weight[2][i]));
  return w;
}

template <class Vector>
glm::vec3 interpolate(const Weights& w, const Vector& a, const Vector& b, const Vector& c) {
  glm::vec3 sum;
  for (int i = 0; i < 3; ++i) sum[i] = std::fma(w.vertex[0], a[i], std::fma(w.vertex[1], b[i], w.vertex[2] * c[i]));
  return sum;
}

glm::vec3 eye_position(const FramePlan& plan, int x, int y, float distance) {
  const float across = std::fma(static_cast<float>(x) + 0.5f, plan.camera.ray[0], plan.camera.ray[1]);
  const float up = std::fma(static_cast<float>(y) + 0.5f, plan.camera.ray[2], plan.camera.ray[3]);
  if (!plan.camera.parallel) return {across * distance, up * distance, -distance};
  return {std::fma(distance, plan.camera.slant[0], across), std::fma(distance, plan.camera.slant[1], up), -distance};
}

}  // namespace

float eye_distance(const FramePlan& plan, float depth) {
  return plan.camera.parallel ? -depth : plan.camera.near / depth;
}

glm::vec3 shade(const FramePlan& plan, const Visibility& visible, const std::vector<std::vector<Vertex>>& vertices,
                int x, int y) {
  const Sample& sample = visible.sample(x, y);
  const Draw& draw = plan.draws[sample.draw];
  glm::vec3 color(draw.base_color[0], draw.base_color[1], draw.base_color[2]);
  if (draw.shading == Shading::wireframe) return color;

  const glm::uvec3 triangle = draw.mesh->triangles[sample.primitive];
  const Vertex *a = &vertices[sample.draw][triangle[0]], *b = &vertices[sample.draw][triangle[1]],
               *c = &vertices[sample.draw][triangle[2]];
  Face face;
  if (draw.shading == Shading::flat) {
    face = face_of(plan, draw, a->position, b->position, c->position);
    if (!draw.lit_per_pixel) color *= lambert(plan, face.normal, face.centre);
  }
  if (draw.shading != Shading::smooth && !draw.lit_per_pixel && !draw.vertex_colors) return color;

  Weights w;
  if (sample.piece == no_piece) {
    const ScreenVertex corner[3] = {a->screen, b->screen, c->screen};
    w = screen_weights(plan, corner, x, y);
  } else {
    const Piece& piece = visible.pieces[sample.piece];
    w = source_weights(screen_weights(plan, piece.corner, x, y), piece);
  }
  if (draw.shading == Shading::smooth || draw.lit_per_pixel) {
    glm::vec3 normal = face.normal;
    if (draw.shading == Shading::smooth) {
      normal = interpolate(w, a->normal, b->normal, c->normal);
      // The weights carry the sign of the orientation on the screen, negative for front faces of unmirrored objects.
      if (draw.double_sided ? !draw.mirrored : w.total() < 0.0f) normal = -normal;
    }
    // A coarse depth buffer decides what is seen, not how it is lit.
    const float distance = is_forward(plan.depth_format) ? w.distance : eye_distance(plan, sample.depth);
    color *= lambert(plan, normal, eye_position(plan, x, y, distance));
  }
  if (draw.vertex_colors) {
    const glm::vec3 tint = interpolate(w, a->color, b->color, c->color);
    for (int i = 0; i < 3; ++i) color[i] *= tint[i] / w.total();
  }
  return color;
}

}  // namespace morphcl::reference
