// The renderers' fp32 against fp64 on the same grid, pixel by pixel, within bounds that follow from the arithmetic.
//
// u = 2^-24. A component of clip space is a matrix row, rounded, times a morphed point: 4 roundings of the row's terms
// and 2 more for each morph target, relative to the sum of the terms' sizes. So vertex_bound = (2 targets + 8) u S / w.
//
// Snapping turns that into 0 or 1 sub-pixel, rarely more where a vertex lies far outside the picture: `shift`. Rounding
// to corner units, where planes go through, likewise: `plane_shift`.
//
// Depth D (1 / distance, or the distance where projectors are parallel) is affine on the screen. A pixel is a
// combination b of the corners p + plane_shift, convex but where the grid covers what is outside the corners, so the
// true plane D there differs from the same combination of corner depths by exactly gradient . sum(b plane_shift). To
// that come the corners' own errors and the roundings of the evaluation, 12 of them, of terms that start at a pixel up
// to 64 away:
//   |D' - D| <= sum |b| (|gradient| plane_shift + vertex_bound max D) + 24 u (sum |b| max D + 64 * 256 G),
// with G the gradient without cancellation, its terms taken by their sizes.
//
// Colours are bounded where the triangle's vertices snap as they should: light from directions is a cosine, whose error
// is that of the normal. Of a flat face it is 12 u |a||b| / |a x b| for edges a and b, of a smooth one 64 u and four
// times vertex_bound (weights, vertex normals) over the length of the interpolated normal; everything after that is
// below 8 u.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/scene_vertices.hpp"
#include "host/render/reference/shown_pixels.hpp"
#include "lab/frame_error/precise_frame.hpp"
#include "lab/frame_error/stored_number.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::accuracy {
namespace {

constexpr double u = 0x1p-24;
using Truth64 = PreciseFrame<OnGrid<double>>;

struct JudgedVertex {
  bool on_screen;                    // fp32 needed no clipping
  ScreenPoint<std::int64_t> screen;  // exact
  ScreenPoint<double> plane;         // exact, rounded to corner units
  double shift_x, shift_y;           // of fp32, sub-pixels
  double plane_shift_x, plane_shift_y;
  double bound;  // vertex_bound of w
};

class JudgedScene {
 public:
  JudgedScene(const Scene& scene, std::int64_t frame)
      : truth(scene, frame), plan(*plan_frame(scene, frame)), shown(reference::shown_pixels(plan)) {
    const RasterGrid grid(plan.width, plan.height);
    vertices_.resize(scene.objects.size());
    for (const Draw& draw : plan.draws) {
      draw_of_[draw.object] = &draw;
      const auto rendered = reference::project_vertices(draw, plan, grid);
      for (std::size_t i = 0; i < rendered.size(); ++i)
        vertices_[draw.object].push_back(judge(draw, i, rendered[i], truth.objects()[draw.object].vertices[i]));
    }
  }

  const Draw& draw(std::uint32_t object) const { return *draw_of_.at(object); }
  const JudgedVertex& vertex(std::uint32_t object, std::uint32_t i) const { return vertices_[object][i]; }

  const Truth64 truth;
  const FramePlan plan;
  const std::vector<reference::ShownPixel> shown;

 private:
  JudgedVertex judge(const Draw& draw, std::size_t i, const reference::Vertex& rendered,
                     const PreciseVertex<double>& exact) const {
    const auto terms = [&](const morphcl::Row& row) {
      double sum = std::abs(row[3]);
      for (int c = 0; c < 3; ++c) {
        double size = std::abs(draw.mesh->positions[i][c]);
        for (const ActiveTarget& active : draw.targets)
          if (const auto& moved = draw.mesh->targets[active.target].positions; !moved.empty())
            size += std::abs(active.weight * moved[i][c]) + std::abs(active.base_weight * draw.mesh->positions[i][c]);
        sum += std::abs(row[c]) * size;
      }
      return sum;
    };
    const double roundings = 2.0 * static_cast<double>(draw.targets.size()) + 8;
    JudgedVertex v{rendered.outcode == 0, {}, {}, 0, 0, 0, 0, roundings * u * terms(draw.object_to_clip[3]) / exact.w};
    if (!v.on_screen) return v;
    const Corner<double> corner{exact.x, exact.y, exact.w, exact.distance, {}};
    v.screen = to_screen<OnGrid<double>>(corner, plan.width, plan.height);
    v.plane = corner_of_plane<OnGrid<double>>(corner, plan.width, plan.height);
    v.shift_x = std::abs(static_cast<double>(rendered.screen.x - v.screen.x));
    v.shift_y = std::abs(static_cast<double>(rendered.screen.y - v.screen.y));
    constexpr double unit = 1.0 / layout::corner_units;
    v.plane_shift_x = std::abs(static_cast<double>(rendered.screen.corner_x()) * unit - v.plane.x);
    v.plane_shift_y = std::abs(static_cast<double>(rendered.screen.corner_y()) * unit - v.plane.y);
    // In units of the grid.
    const auto max = [&](int row, double value, double half) {
      const double error =
          roundings * u * terms(draw.object_to_clip[row]) / exact.w + std::abs(value / exact.w) * v.bound;
      return 1 + std::floor(error * half);
    };
    const double half_width = 128.0 * plan.width, half_height = 128.0 * plan.height;
    EXPECT_LE(v.shift_x, max(0, exact.x, half_width)) << "vertex " << i;
    EXPECT_LE(v.shift_y, max(1, exact.y, half_height)) << "vertex " << i;
    EXPECT_LE(v.plane_shift_x, unit * max(0, exact.x, half_width / unit)) << "vertex " << i;
    EXPECT_LE(v.plane_shift_y, unit * max(1, exact.y, half_height / unit)) << "vertex " << i;
    return v;
  }

  std::vector<std::vector<JudgedVertex>> vertices_;
  std::map<std::uint32_t, const Draw*> draw_of_;
};

struct Triangle {
  const JudgedVertex* judged[3];
  const PreciseVertex<double>* exact[3];
  bool unclipped = true, snapped_right = true;
  double vertex_bound = 0, shift_x = 0, shift_y = 0, plane_shift_x = 0, plane_shift_y = 0;

  Triangle(const JudgedScene& scene, std::uint32_t object, std::uint32_t primitive) {
    const glm::uvec3 corners = scene.draw(object).mesh->triangles[primitive];
    for (int i = 0; i < 3; ++i) {
      judged[i] = &scene.vertex(object, corners[i]);
      exact[i] = &scene.truth.objects()[object].vertices[corners[i]];
      unclipped &= judged[i]->on_screen;
      vertex_bound = std::max(vertex_bound, judged[i]->bound);
      shift_x = std::max(shift_x, judged[i]->shift_x);
      shift_y = std::max(shift_y, judged[i]->shift_y);
      plane_shift_x = std::max(plane_shift_x, judged[i]->plane_shift_x);
      plane_shift_y = std::max(plane_shift_y, judged[i]->plane_shift_y);
    }
    snapped_right = shift_x == 0 && shift_y == 0;
  }

  // At a pixel's centre.
  double depth_bound(bool parallel, int px, int py) const {
    double d[3], x[3], y[3], largest = 0;
    for (int i = 0; i < 3; ++i) {
      d[i] = parallel ? exact[i]->distance : 1 / exact[i]->distance;
      x[i] = judged[i]->plane.x;
      y[i] = judged[i]->plane.y;
      largest = std::max(largest, std::abs(d[i]));
    }
    const double x1 = x[1] - x[0], x2 = x[2] - x[0], y1 = y[1] - y[0], y2 = y[2] - y[0];
    const double d1 = d[1] - d[0], d2 = d[2] - d[0], area = std::abs(x1 * y2 - x2 * y1);
    const double gradient_x = std::abs(y2 * d1 - y1 * d2) / area, gradient_y = std::abs(x1 * d2 - x2 * d1) / area;
    const double terms = (std::abs(y2 * d1) + std::abs(y1 * d2) + std::abs(x1 * d2) + std::abs(x2 * d1)) / area;
    const double ox = pixel_centre(px) - x[0], oy = pixel_centre(py) - y[0], sign = x1 * y2 - x2 * y1 < 0 ? -1 : 1;
    const double b1 = sign * (ox * y2 - oy * x2) / area, b2 = sign * (oy * x1 - ox * y1) / area;
    const double sizes = std::abs(1 - b1 - b2) + std::abs(b1) + std::abs(b2);
    return sizes * (gradient_x * plane_shift_x + gradient_y * plane_shift_y + vertex_bound * largest) +
           24 * u * (sizes * largest + 64 * 256 * terms);
  }
};

// Distances of all pixels whose triangle neither render clips.
TEST(ErrorBound, Distances) {
  std::size_t judged = 0, exact_snaps = 0;
  double closest = 0;
  for (const auto& [name, scene, frames] : test::test_scenes(160, 90)) {
    SCOPED_TRACE(name);
    const JudgedScene judge(scene, frames.back());
    for (std::size_t i = 0; i < judge.shown.size(); ++i) {
      const reference::ShownPixel& shown = judge.shown[i];
      if (shown.object == reference::nothing_shown || judge.draw(shown.object).shading == Shading::wireframe) continue;
      const Triangle triangle(judge, shown.object, shown.primitive);
      const int x = static_cast<int>(i) % 160, y = static_cast<int>(i) / 160;
      const auto hit = triangle.unclipped ? judge.truth.hit(shown.object, shown.primitive, x, y) : std::nullopt;
      if (!hit) continue;
      const double error = judge.plan.camera.parallel ? std::abs(shown.distance - hit->distance)
                                                      : std::abs(1 / double{shown.distance} - 1 / hit->distance);
      const double stored = u * (judge.plan.camera.parallel ? std::abs(hit->distance) : 2 / hit->distance);
      const double bound = triangle.depth_bound(judge.plan.camera.parallel, x, y) + stored;
      ASSERT_LE(error, bound) << "pixel " << x << ", " << y << ": distance " << shown.distance << ", exact "
                              << hit->distance;
      closest = std::max(closest, error / bound);
      ++judged;
      exact_snaps += triangle.snapped_right;
    }
  }
  EXPECT_GT(judged, 50000u);
  EXPECT_GT(exact_snaps, judged / 2) << "most vertices snap as they should";
  RecordProperty("largest_share_of_bound", std::to_string(closest));
}

double lit_bound(const Triangle& triangle, const PreciseObject<double>& object, const Hit<double>& hit) {
  if (object.shading == Shading::unlit) return 0;
  if (object.shading == Shading::flat) {
    const auto a = triangle.exact[1]->position - triangle.exact[0]->position;
    const auto b = triangle.exact[2]->position - triangle.exact[0]->position;
    const auto normal = cross(a, b);
    return 12 * u * std::sqrt(dot(a, a) * dot(b, b) / dot(normal, normal));
  }
  Vector3<double> normal{};
  for (std::size_t i = 0; i < 3; ++i) normal = normal + triangle.exact[i]->normal * hit.weight[i];
  return (64 * u + 4 * triangle.vertex_bound) / std::sqrt(dot(normal, normal));
}

TEST(ErrorBound, ColorsUnderDirectionalLight) {
  std::size_t judged[3] = {};  // flat, smooth, unlit
  double closest = 0;
  for (const auto& [name, scene, frames] : test::test_scenes(160, 90)) {
    SCOPED_TRACE(name);
    const JudgedScene judge(scene, frames.back());
    const auto is_point = [](const EyeLight& light) { return light.kind == LightKind::point; };
    if (std::any_of(judge.plan.lights.begin(), judge.plan.lights.end(), is_point)) continue;
    for (std::size_t i = 0; i < judge.shown.size(); ++i) {
      const reference::ShownPixel& shown = judge.shown[i];
      if (shown.object == reference::nothing_shown) continue;
      const PreciseObject<double>& object = judge.truth.objects()[shown.object];
      if (object.shading == Shading::wireframe || !judge.draw(shown.object).targets.empty()) continue;
      const Triangle triangle(judge, shown.object, shown.primitive);
      const int x = static_cast<int>(i) % 160, y = static_cast<int>(i) / 160;
      const auto hit = judge.truth.hit(shown.object, shown.primitive, x, y);
      if (!hit || !triangle.unclipped || !triangle.snapped_right) continue;
      const Vector3<double> exact = judge.truth.color(shown.object, shown.primitive, *hit, x, y);
      const double channels[3] = {exact.x, exact.y, exact.z};
      const double base[3] = {object.base_color.x, object.base_color.y, object.base_color.z};
      const double lights = 1;  // every scene's key light is white
      for (int c = 0; c < 3; ++c) {
        const double tint = object.has_colors ? (12 * u + 4 * triangle.vertex_bound) * base[c] : 0;
        const double bound = base[c] * lights * lit_bound(triangle, object, *hit) + 8 * u * base[c] + tint;
        const double error = std::abs(shown.color[c] - channels[c]);
        ASSERT_LE(error, bound) << "pixel " << x << ", " << y << " channel " << c << ": " << shown.color[c]
                                << ", exact " << channels[c];
        closest = std::max(closest, error / bound);
      }
      ++judged[static_cast<int>(object.shading)];
    }
  }
  EXPECT_GT(judged[0], 2000u);
  EXPECT_GT(judged[1], 2000u);
  EXPECT_GT(judged[2], 2000u);
  RecordProperty("largest_share_of_bound", std::to_string(closest));
}

// A pixel can differ in coverage only where an edge passes by that a shifted vertex moved: within sqrt(2) times the
// shift of an exact edge of the triangle that one of the renders shows there.
TEST(ErrorBound, CoverageDiffersOnlyBesideShiftedEdges) {
  std::size_t different = 0, pixels = 0;
  constexpr int width = 1920, height = 1080;  // small pictures have no such pixel
  for (const double side : {0.4, 1.1, 1.7}) {
    SCOPED_TRACE(side);
    test::SceneBuilder builder(width, height);
    builder.add(make_grid({40, 40}), Shading::unlit, test::place({0, 0, 0}, 3));  // edges of 200,000 pixels together
    const Scene& scene = builder.look({side, 1.1, 1.3}).scene();
    const JudgedScene judge(scene, 0);
    const auto visible = judge.truth.find_visible();
    for (std::size_t i = 0; i < judge.shown.size(); ++i) {
      const reference::ShownPixel& shown = judge.shown[i];
      pixels += shown.object != reference::nothing_shown;
      if (shown.object == reference::nothing_shown || judge.draw(shown.object).shading == Shading::wireframe) continue;
      if (shown.object == visible[i].object && shown.primitive == visible[i].primitive) continue;
      const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
      const Triangle triangle(judge, shown.object, shown.primitive);
      if (!triangle.unclipped || judge.truth.hit(shown.object, shown.primitive, x, y)) continue;  // the order differs
      ++different;
      EXPECT_FALSE(triangle.snapped_right) << x << ", " << y;
      double nearest = 1e9;
      for (int k = 0; k < 3; ++k) {
        const auto &a = triangle.judged[k]->screen, &b = triangle.judged[(k + 1) % 3]->screen;
        const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
        const double px = pixel_centre(x) - static_cast<double>(a.x), py = pixel_centre(y) - static_cast<double>(a.y);
        const double along = std::clamp((px * dx + py * dy) / std::max(dx * dx + dy * dy, 1.0), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(px - along * dx, py - along * dy));
      }
      EXPECT_LE(nearest, std::hypot(triangle.shift_x, triangle.shift_y)) << x << ", " << y << ", sub-pixels";
    }
  }
  EXPECT_GT(different, 0u) << "or nothing was tested";
  EXPECT_LT(different, pixels / 10000);
}

}  // namespace
}  // namespace morphcl::accuracy
