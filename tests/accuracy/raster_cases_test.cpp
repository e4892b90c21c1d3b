// Catalogue of extreme cases: clipping, snapping, coverage and normals, by the renderers' own arithmetic (the plain
// loops that every device equals bit for bit).
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/reference/clip_polygon.hpp"
#include "host/render/reference/shade.hpp"
#include "host/render/reference/visibility.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/solids.hpp"
#include "tests/accuracy/demand.hpp"
#include "tests/accuracy/naive_forms.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/support/random.hpp"

namespace morphcl::accuracy {
namespace {

using reference::ClipPoint;
using reference::Corner;
using test::SceneBuilder;
using test_support::Random;

FramePlan perspective_plan(int width, int height) {
  static Scene scene = [] {
    SceneBuilder builder(64, 64);
    builder.add(make_cube(), Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
    return builder.look({0, 0, 5}).project(Perspective{90, 0.1, 100}).scene();
  }();
  FramePlan plan = *plan_frame(scene, 0);
  plan.width = width;
  plan.height = height;
  return plan;
}

// For comparisons bit by bit, in which -0 is not +0.
std::array<std::uint32_t, 4> bits_of(const ClipPoint& p) { return std::bit_cast<std::array<std::uint32_t, 4>>(p); }

Corner corner(const glm::vec4& clip) { return {{clip.x, clip.y, clip.z, clip.w}, {0, 0, 0}}; }
glm::vec4 any_clip_point(Random& random, double low_w, double high_w) {
  return {random.float_in(-1, 1), random.float_in(-1, 1), 0.1f, random.float_in(low_w, high_w)};
}

TEST(ExtremeCase, BehindTheEye) {
  const FramePlan plan = perspective_plan(640, 480);
  const RasterGrid grid(plan.width, plan.height);
  Random random(12);
  Worst stable, naive_form;
  std::vector<std::vector<glm::vec4>> polygons = {{{1, 0, 0.1f, 1}, {1, 0, 0.1f, -1}},
                                                  {{1, 0, 0.1f, 0.0f}, {1, 0, 0.1f, 1}},
                                                  {{1, 0, 0.1f, -0.0f}, {0, 0, 0, 0.0f}}};
  for (int i = 0; i < 5000; ++i) {
    polygons.push_back({});
    for (int k = 0; k < 2 + i % 2; ++k) polygons.back().push_back(any_clip_point(random, -1, 1));
  }
  for (const auto& polygon : polygons) {
    std::vector<Corner> corners;
    for (const glm::vec4& p : polygon) {
      corners.push_back(corner(p));
      const glm::vec2 image = naive::project(p);
      // An image is what lies in front of the near plane.
      naive_form.add_exact(p.w >= plan.camera.near_w || !(std::isfinite(image.x) && std::isfinite(image.y)));
    }
    for (const Corner& left : reference::clip_polygon(corners, plan, grid))
      stable.add_exact(left.clip.w >= plan.camera.near_w && std::isfinite(left.clip.x) && std::isfinite(left.clip.y));
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, NearClipping) {
  const FramePlan plan = perspective_plan(640, 480);
  const RasterGrid grid(plan.width, plan.height);
  Random random(13);
  Worst stable, naive_form;
  int cut = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::vec4 inner = any_clip_point(random, 0.2, 2), outer = any_clip_point(random, -2, 0.05);
    const auto forward = reference::clip_polygon({corner(inner), corner(outer)}, plan, grid);
    const auto backward = reference::clip_polygon({corner(outer), corner(inner)}, plan, grid);
    const glm::vec4 a = naive::cut(inner, outer, plan.camera.near_w), b = naive::cut(outer, inner, plan.camera.near_w);
    naive_form.add_exact(a == b && a.w == plan.camera.near_w);
    stable.add_exact(forward.size() == backward.size());
    if (forward.size() != 2 || backward.size() != 2) continue;
    ++cut;
    stable.add_exact(bits_of(forward[1].clip) == bits_of(backward[0].clip));
    stable.add_exact(forward[1].clip.w >= plan.camera.near_w);
    const bool inside_guard = std::abs(outer.x) < 0.02f && std::abs(outer.y) < 0.02f;
    if (inside_guard) stable.add_exact(forward[1].clip.w == plan.camera.near_w);
  }
  EXPECT_GT(cut, 1000);
  // The known cut, from w = 1 to w = -1 with near at w = 1/10: t = 9/20, x stays (inside the guard band).
  const auto known =
      reference::clip_polygon({{{0.05f, 0, 0.1f, 1}, {1, 0, 0}}, {{0.05f, 0, 0.1f, -1}, {0, 1, 0}}}, plan, grid);
  ASSERT_EQ(known.size(), 2u);
  EXPECT_EQ(known[1].clip.x, 0.05f);
  EXPECT_EQ(known[1].clip.w, plan.camera.near_w);
  EXPECT_FLOAT_EQ(known[1].weight[0], 11 / 20.0f);
  EXPECT_FLOAT_EQ(known[1].weight[1], 9 / 20.0f);
  expect_demand(stable, naive_form);
}

Real round_half_even(const Real& v) {
  const Real low = floor(v), part = v - low;
  if (part < Real(0.5)) return low;
  if (part > Real(0.5)) return low + 1;
  return fmod(low, Real(2)) == 0 ? low : Real(low + 1);
}

TEST(ExtremeCase, ViewportOf16384Pixels) {
  const RasterGrid grid(16384, 16384);
  Random random(14);
  Worst stable, naive_form;
  for (int i = 0; i < 50'000; ++i) {
    const auto w = static_cast<float>(std::exp2(random.in(-10, 10)));
    const float x = random.float_in(-1, 1) * w;
    const Real exact = round_half_even(Real(x) / Real(w) * Real(grid.scale_x) + Real(grid.offset_x));
    stable.add_exact(Real(reference::to_screen({x, 0, 1, w}, grid).x) == exact);
    naive_form.add_exact(Real(naive::snap(x, w, grid.scale_x, grid.offset_x)) == exact);
  }
  expect_demand(stable, naive_form);
}

// A fan of slivers from a corner far outside the image, whose edges run through pixel centres or half a sub-pixel
// beside them: each centre is in exactly one sliver, and in the right one.
TEST(ExtremeCase, ThinTriangles) {
  FramePlan plan = perspective_plan(64, 64);
  const RasterGrid grid(plan.width, plan.height);
  constexpr int slivers = 60, apex_x = -6'000'001, apex_y = -5'000'003;  // sub-pixels
  std::vector<reference::Vertex> vertices(slivers + 2);
  const auto place = [&](std::size_t i, int x, int y) {
    vertices[i] = {};
    vertices[i].screen = {x, y, 0.5f, 1};
  };
  place(0, apex_x, apex_y);
  for (int i = 0; i <= slivers; ++i) {
    const int x = (63 - i) * 256 + 128, y = i * 256 + 128;
    place(static_cast<std::size_t>(i) + 1, 2 * x - apex_x + i % 3 - 1, 2 * y - apex_y);
  }
  // Twice the signed area of a, b and the centre of pixel (x, y).
  const auto side = [&](std::size_t a, std::size_t b, int x, int y) {
    const reference::ScreenVertex &p = vertices[a].screen, &q = vertices[b].screen;
    return std::int64_t{q.x - p.x} * (y * 256 + 128 - p.y) - std::int64_t{q.y - p.y} * (x * 256 + 128 - p.x);
  };
  std::vector<int> hits(64 * 64, 0), right(64 * 64, 0);
  Worst stable, naive_form;
  Mesh one;
  one.positions.resize(slivers + 2);
  plan.draws.resize(1);
  plan.draws[0].mesh = &one;
  for (unsigned i = 0; i < slivers; ++i) {
    one.triangles = {{0, i + 1, i + 2}};
    const reference::Visibility visible = reference::find_visible(plan, grid, {vertices});
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const auto at = static_cast<std::size_t>(y * 64 + x);
        const bool covered = visible.samples[at].order != reference::no_order;
        const std::int64_t sides[] = {side(0, i + 1, x, y), side(i + 1, i + 2, x, y), side(i + 2, 0, x, y)};
        const bool inside = sides[0] > 0 && sides[1] > 0 && sides[2] > 0;
        const bool outside = sides[0] < 0 || sides[1] < 0 || sides[2] < 0;
        hits[at] += covered;
        right[at] += inside || !outside;
        if (inside || outside) stable.add_exact(covered == inside);
        const auto point = [&](std::size_t k) { return glm::ivec2(vertices[k].screen.x, vertices[k].screen.y); };
        const glm::ivec2 centre(x * 256 + 128, y * 256 + 128);
        bool naive_inside = true;
        for (const auto& [a, b] : {std::pair{0u, i + 1}, std::pair{i + 1, i + 2}, std::pair{i + 2, 0u}})
          naive_inside = naive_inside && naive::edge_signs(point(a), point(b), centre)[1] > 0;
        if (inside || outside) naive_form.add_exact(naive_inside == inside);
      }
  }
  for (std::size_t i = 0; i < hits.size(); ++i) stable.add_exact(right[i] == 0 ? hits[i] == 0 : hits[i] == 1);
  EXPECT_GT(std::count(hits.begin(), hits.end(), 1), 500) << "the slivers miss the image";
  expect_demand(stable, naive_form);
}

// Normals that a morph turns to the other side: exactly opposed, and up to a little.
TEST(ExtremeCase, OpposedMorphNormals) {
  Mesh mesh;
  MorphTarget target;
  target.name = "turned";
  target.form = TargetForm::absolute;
  Random random(15);
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 normal(glm::normalize(random.vector(1)));
    const float off = i % 3 == 0 ? 0 : i % 3 == 1 ? 1e-4f : 1e-7f;
    mesh.positions.push_back({random.float_in(-1, 1), random.float_in(-1, 1), random.float_in(-1, 1)});
    mesh.normals.push_back(normal);
    target.normals.push_back(-normal + off * glm::vec3(normal.y, normal.z, normal.x));
  }
  for (unsigned i = 0; i < 300; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  mesh.targets.push_back(target);
  SceneBuilder builder(64, 64);
  const int object = builder.add(mesh, Shading::smooth);
  builder.weight(object, 0.5).look({0, 0, 5});
  const FramePlan plan = *plan_frame(builder.scene(), 0);
  const auto vertices = reference::project_vertices(plan.draws.at(0), plan, RasterGrid(64, 64));
  Worst stable, naive_form;
  const auto length = [](const glm::vec3& v) { return glm::length(glm::dvec3(v)); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    // A unit vector of fp32: each component half an ulp, the length and the quotient two roundings.
    stable.add(length(vertices[i].normal), 1, 4 * u32);
    naive_form.add(length(naive::morphed_normal(mesh.normals[i], target.normals[i], 0.5f)), 1, 4 * u32);
  }
  expect_demand(stable, naive_form);
}

// Row "perspective interpolation", as renderers do it: vertex colours at the first pixel's centre. Exact for the
// snapped corners and their rounded 1 / w.
TEST(ExtremeCase, PerspectiveInterpolationOfPixels) {
  Mesh mesh;
  mesh.positions.resize(3);
  mesh.triangles = {{0, 1, 2}};
  FramePlan plan = perspective_plan(1, 1);
  plan.draws.resize(1);
  Draw& draw = plan.draws[0];
  draw.mesh = &mesh;
  draw.shading = Shading::unlit;
  draw.vertex_colors = true;
  draw.base_color = {1, 1, 1, 1};
  reference::Visibility visible;
  visible.samples = {{.depth = 0.5f, .key = 0, .order = 0, .draw = 0, .primitive = 0, .piece = reference::no_piece}};
  Random random(29);
  Worst stable, naive_form;
  int inside = 0;
  while (inside < 50'000) {
    std::vector<reference::Vertex> corners(3);
    long long x[3], y[3], area[3];
    const long long reach = 256LL << (inside % 14);
    for (int i = 0; i < 3; ++i) {
      x[i] = random.integer_in(-reach, reach);
      y[i] = random.integer_in(-reach, reach);
      corners[i].screen = {static_cast<int>(x[i] + 128), static_cast<int>(y[i] + 128), 0,
                           static_cast<float>(std::pow(10.0, random.in(-3, 3)))};
    }
    for (int i = 0; i < 3; ++i) area[i] = x[(i + 1) % 3] * y[(i + 2) % 3] - x[(i + 2) % 3] * y[(i + 1) % 3];
    if (!(std::min({area[0], area[1], area[2]}) > 0 || std::max({area[0], area[1], area[2]}) < 0)) continue;
    const bool one_sign = inside++ % 2 == 0;
    glm::vec3 areas, inverse_w, attribute;
    Real sum = 0, total = 0;
    float largest = 0;
    for (int i = 0; i < 3; ++i) {
      attribute[i] = random.float_in(one_sign ? 0.25 : -1, 1);
      largest = std::max(largest, std::abs(attribute[i]));
      corners[i].color = glm::vec4(attribute[i]);
      areas[i] = static_cast<float>(area[i]);
      inverse_w[i] = corners[i].screen.inverse_w;
      const Real exact = Real(area[i]) * inverse_w[i];
      sum += exact * attribute[i];
      total += exact;
    }
    const Real value = sum / total;
    const double bound = one_sign ? 5 * ulp32(value) : 5 * u32 * largest;
    stable.add(reference::shade_centre(plan, visible, visible.sample(0, 0), {corners}, 0, 0).color.x, value, bound);
    naive_form.add(naive::attribute_at(areas, inverse_w, attribute), value, bound);
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, NaNAndInfinity) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  Mesh mesh;
  mesh.name = "bad";
  mesh.triangles = {{0, 1, 2}};
  Worst stable, naive_form;
  for (const float bad : {nan, -nan, infinity, -infinity})
    for (int component = 0; component < 3; ++component) {
      // On import: refused.
      mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      mesh.positions[1][component] = bad;
      bool refused = false;
      try {
        validate(mesh);
      } catch (const Error&) {
        refused = true;
      }
      stable.add_exact(refused);
      // In a renderer that got it nevertheless: the primitive is left out.
      FramePlan plan = perspective_plan(32, 32);
      plan.draws.resize(1);
      plan.draws[0].mesh = &mesh;
      const RasterGrid grid(32, 32);
      const auto vertices = reference::project_vertices(plan.draws[0], plan, grid);
      stable.add_exact(vertices[1].outcode != 0);
      const reference::Visibility visible = reference::find_visible(plan, grid, {vertices});
      for (const reference::Sample& sample : visible.samples) stable.add_exact(sample.order == reference::no_order);
      if (std::isnan(bad)) naive_form.add_exact(!naive::keeps_clip_point(bad, 1));
    }
  expect_demand(stable, naive_form);
}

}  // namespace
}  // namespace morphcl::accuracy
