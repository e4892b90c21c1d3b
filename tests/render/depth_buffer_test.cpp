// Depth buffers of every format: the device draws the reference's bits, and what is seen is what such a buffer shows,
// judged by 113 bits.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/reference/visibility.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/math/reference.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

using reference::infinity;
using Exact = boost::multiprecision::cpp_bin_float_quad;  // 113 bits

FrameBuffer draw(Renderer& renderer, const Plan& plan) {
  FrameBuffer pixels(plan->width, plan->height, plan->channels);
  renderer.render(plan, pixels);
  return pixels;
}

FrameBuffer draw(const Scene& scene) { return draw(*make_reference_renderer(), plan_frame(scene, 0)); }

// 1 on the near plane, 0 on the far one, for the near plane as renderers have it.
Exact normalized_depth(const Plan& plan, double far, const Exact& distance) {
  if (plan->camera.parallel) return (Exact(far) - distance) / (Exact(far) + Exact(plan->camera.near_depth));
  const Exact ratio = std::isinf(far) ? Exact(0) : Exact(plan->camera.near) / Exact(far);
  return (Exact(plan->camera.near) / distance - ratio) / (1 - ratio);
}

class DepthBuffers : public ::testing::TestWithParam<DepthFormat> {
 protected:
  Scene with_format(Scene scene) const {
    scene.image.depth_format = GetParam();
    return scene;
  }
  // What is stored, in numbers of which the larger is nearer.
  Exact stored(const Exact& exact_normalized_depth) const {
    if (GetParam() == DepthFormat::forward_float) return -Exact(static_cast<float>(Exact(1 - exact_normalized_depth)));
    return round(exact_normalized_depth * Exact(steps_of(GetParam())));
  }
};
INSTANTIATE_TEST_SUITE_P(Formats, DepthBuffers, ::testing::ValuesIn(depth_formats),
                         [](const auto& format) { return std::string(name_of(format.param)); });

class ForwardDepthBuffers : public DepthBuffers {};
INSTANTIATE_TEST_SUITE_P(Formats, ForwardDepthBuffers,
                         ::testing::ValuesIn(depth_formats.begin() + 1, depth_formats.end()),
                         [](const auto& format) { return std::string(name_of(format.param)); });

class FixedDepthBuffers : public DepthBuffers {};
INSTANTIATE_TEST_SUITE_P(Formats, FixedDepthBuffers,
                         ::testing::ValuesIn(depth_formats.begin() + 2, depth_formats.end()),
                         [](const auto& format) { return std::string(name_of(format.param)); });

TEST_P(DepthBuffers, TheDeviceDrawsTheReferencesBits) {
  const auto reference = make_reference_renderer(), device = make_device_renderer(shared_session());
  for (const TestScene& test : test_scenes(150, 90)) {
    const Scene scene = with_format(test.scene);
    const Plan plan = plan_frame(scene, test.frames.back()),
               whole = plan_frame(scene, test.frames.back(), {.leave_out = false});
    const FrameBuffer expected = draw(*reference, plan);
    EXPECT_TRUE(same_pixels(expected, draw(*device, plan))) << test.name;
    EXPECT_TRUE(same_pixels(expected, draw(*device, whole))) << test.name << ", nothing left out";
  }
}

TEST_P(DepthBuffers, NoPixelDependsOnTheFormatWhereNothingIsBehind) {
  const auto colors_of = [](const FrameBuffer& frame, int c) {
    std::vector<std::uint16_t> values;
    for (int y = 0; y < frame.height(); ++y)
      values.insert(values.end(), frame.color_row(c, y).begin(), frame.color_row(c, y).end());
    return values;
  };
  const Scene scene = pyramid_to_cube(120, 90);
  const FrameBuffer usual = draw(scene), other = draw(with_format(scene));
  for (int c = 0; c < 4; ++c) EXPECT_EQ(colors_of(usual, c), colors_of(other, c));
}

// Red squares side by side, each of them behind a green one by the same part of its distance. A pixel shows green
// where the buffer tells the two distances apart, and red, which comes first, where it does not.
struct Pairs {
  static constexpr int cells = 64;
  std::vector<float> nearer, farther;  // distances, one a pixel
  Scene scene;

  Pairs(double near, double far, double farthest, double gap, unsigned seed) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < cells * cells; ++i) {
      const double u = std::ldexp(static_cast<double>(random() >> 11), -53);  // log-uniform
      nearer.push_back(static_cast<float>(near * 1.001 * std::pow(farthest / near * 0.998, u)));
      farther.push_back(static_cast<float>(nearer.back() * (1 + gap)));
    }
    SceneBuilder b(cells, cells);
    b.add(squares(farther), Shading::unlit, glm::dmat4(1.0), {1, 0, 0, 1});
    b.add(squares(nearer), Shading::unlit, glm::dmat4(1.0), {0, 1, 0, 1});
    b.no_lights().look({0, 0, 0}, {0, 0, -1}).project(Perspective{90, near, far});
    scene = b.scene();
    scene.timeline.ambient = {1, 1, 1};
  }

  bool shows_nearer(const FrameBuffer& frame, int i) const { return frame.color_row(1, i / cells)[i % cells] != 0; }

 private:
  // Around the pixel's centre, where the view is 90 degrees wide.
  static Mesh squares(const std::vector<float>& distances) {
    Mesh mesh;
    for (int i = 0; i < cells * cells; ++i) {
      const int column = i % cells, row = i / cells;
      const float d = distances[i], r = 0.7f / cells, x = (2.0f * static_cast<float>(column) + 1) / cells - 1,
                  y = 1 - (2.0f * static_cast<float>(row) + 1) / cells;
      const auto first = static_cast<unsigned>(mesh.positions.size());
      for (const auto& [sx, sy] : {std::pair{-r, -r}, {r, -r}, {r, r}, {-r, r}})
        mesh.positions.push_back({(x + sx) * d, (y + sy) * d, -d});
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
    return mesh;
  }
};

// Each pair of distances is in the order, or tied, as exact arithmetic rounded once to the format says.
TEST_P(ForwardDepthBuffers, ShowTheNearerOfTwoWhereTheirNumbersDiffer) {
  const auto device = make_device_renderer(shared_session());
  for (const double far : {1e5, infinity})
    for (const double gap : {1e-7, 1e-5, 1e-3}) {
      const Pairs pairs(0.1, far, 1e5, gap, 5);
      const Scene scene = with_format(pairs.scene);
      const Plan plan = plan_frame(scene, 0);
      const FrameBuffer frame = draw(*device, plan);
      int told_apart = 0, wrong = 0;
      for (int i = 0; i < Pairs::cells * Pairs::cells; ++i) {
        const Exact nearer = stored(normalized_depth(plan, far, pairs.nearer[i]));
        const Exact farther = stored(normalized_depth(plan, far, pairs.farther[i]));
        ASSERT_GE(nearer, farther);
        told_apart += nearer > farther;
        wrong += pairs.shows_nearer(frame, i) != (nearer > farther);
      }
      EXPECT_EQ(wrong, 0) << "gap " << gap << ", far " << far << ", " << told_apart << " told apart";
      if (gap == 1e-5) {
        EXPECT_GT(told_apart, 50);
      }
    }
}

// Row "depth bucket" of the catalogue of extreme cases: near = 0.1, far = 1e5.
TEST(ReversedDepthBuffer, TellsApartEveryPairOfARelativeGapOf2ToTheMinus21) {
  for (const double far : {1e5, infinity})
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const Pairs pairs(0.1, far, 1e5, 0x1p-21, seed);
      const FrameBuffer frame = draw(pairs.scene);
      int tied = 0;
      for (int i = 0; i < Pairs::cells * Pairs::cells; ++i) tied += !pairs.shows_nearer(frame, i);
      EXPECT_EQ(tied, 0) << "seed " << seed;
    }
}

// Slanted triangles, small and large: what is stored at every pixel inside is the exact plane through the vertices,
// rounded.
//
// Bound: u^2 = 2^-48. A corner's normalized depth is off by 15 u^2 (quotient, difference, product) of 1 / (1 - near /
// far) < 2, over the area by 15 u^2 more, a term by 5 u^2 and two sums by 3 u^2 each: 60 u^2 of at most 1. From a
// corner to its sub-pixel, half of one at most along both axes, depth changes by the gradient, whose terms are off by 8
// roundings u.
TEST_P(FixedDepthBuffers, StoreTheExactPlaneRoundedOnce) {
  const double rounded = 0.5 + 60 * 0x1p-48 * steps_of(GetParam()) + 0x1p-23;  // of a step; the last: near a tie
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(-1, 1);
  for (const Projection& projection :
       {Projection(Perspective{60, 0.25, 40}), Projection(Perspective{60, 0.25, infinity}),
        Projection(Orthographic{-4, 4, -4, 4, 0.5, 40})}) {
    const double far = far_distance(projection);
    Mesh mesh;
    for (unsigned t = 0; t < 60; ++t) {
      const float size = t % 3 ? 6.0f : 0.1f;
      const glm::vec3 middle{3 * unit(random), 3 * unit(random), -10 - 9 * unit(random)};
      for (int i = 0; i < 3; ++i)
        mesh.positions.push_back(middle + size * glm::vec3{unit(random), unit(random), 0.2f * unit(random)});
      mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    SceneBuilder b(128, 128);
    b.add(mesh, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
    b.look({0, 0, 0}, {0, 0, -1}).project(projection);
    const Scene scene = with_format(b.scene());
    const Plan plan = plan_frame(scene, 0);
    const RasterGrid grid(plan->width, plan->height);
    const auto vertices = reference::project_vertices(plan->draws.at(0), *plan, grid);
    const reference::Visibility visible = reference::find_visible(*plan, grid, {vertices});
    int seen = 0;
    for (int i = 0; i < 128 * 128; ++i) {
      const reference::Sample& sample = visible.samples[i];
      if (sample.order == reference::no_order || sample.piece != reference::no_piece) continue;
      ++seen;
      Exact x[3], y[3], c[3];
      for (int k = 0; k < 3; ++k) {
        const reference::Vertex& v = vertices[3 * sample.primitive + k];
        x[k] = Exact(v.screen.corner_x()) / layout::corner_units;
        y[k] = Exact(v.screen.corner_y()) / layout::corner_units;
        c[k] = normalized_depth(plan, far, plan->camera.parallel ? -Exact(v.clip.z) : Exact(v.clip.w));
      }
      const Exact px = pixel_centre(i % 128), py = pixel_centre(i / 128);
      const Exact area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
      const Exact w1 = ((px - x[0]) * (y[2] - y[0]) - (py - y[0]) * (x[2] - x[0])) / area;
      const Exact w2 = ((x[1] - x[0]) * (py - y[0]) - (y[1] - y[0]) * (px - x[0])) / area;
      if (w1 < 0 || w2 < 0 || w1 + w2 > 1) continue;  // the grid covers it, the triangle does not
      const Exact exact = (c[0] + w1 * (c[1] - c[0]) + w2 * (c[2] - c[0])) * Exact(steps_of(GetParam()));
      const Exact terms = (abs((y[2] - y[0]) * (c[1] - c[0])) + abs((y[1] - y[0]) * (c[2] - c[0])) +
                           abs((x[1] - x[0]) * (c[2] - c[0])) + abs((x[2] - x[0]) * (c[1] - c[0]))) /
                          abs(area);
      const double bound = rounded + static_cast<double>(terms) * 0.5 * 8 * 0x1p-24 * steps_of(GetParam());
      EXPECT_LE(static_cast<double>(abs(exact - Exact(sample.key))), bound) << "pixel " << i;
      // Z stands for the number stored, within three roundings.
      const double distance = distance_of_stored(
          GetParam(), {plan->camera.parallel ? 0.5 : plan->camera.near, far, plan->camera.parallel != 0}, sample.key);
      const float z = plan->camera.parallel ? -sample.depth : plan->camera.near / sample.depth;
      EXPECT_LE(std::abs(z - distance), 4 * 0x1p-24 * std::max(distance, plan->camera.parallel ? far : 0.0))
          << "pixel " << i;
    }
    EXPECT_GT(seen, 2000);
  }
}

// A floor that runs through the far plane: what is nearer is drawn, what is farther is not. The pixel's distance on the
// exact plane decides; pixels within 2^-20 of the far plane are left out.
TEST_P(DepthBuffers, EndAtTheFarPlane) {
  for (const bool parallel : {false, true}) {
    constexpr double far = 30;
    SceneBuilder b(160, 120);
    b.add(make_grid({1, 1}), Shading::unlit, place({0, -1, 0}, 400), {1, 1, 1, 1}, true);
    b.look({0, 0, 0}, {0, -0.1, -1});
    parallel ? b.project(Orthographic{-8, 8, -6, 6, 1, far}) : b.project(Perspective{50, 0.1, far});
    const Scene& scene = with_format(b.scene());
    const Plan plan = plan_frame(scene, 0);
    const FrameBuffer frame = draw(scene);
    int drawn = 0, beyond = 0;
    for (int y = 0; y < 120; ++y) {
      // y_eye and distance of the pixel's ray; the floor is y_world = -1.
      const double t = plan->camera.ray[2] * (y + 0.5) + plan->camera.ray[3], down = 0.1 / std::sqrt(1.01),
                   ahead = 1 / std::sqrt(1.01);
      const double d = parallel ? (1 + t * ahead) / down : -1 / (t * ahead - down);
      if (!(d > 1.1) && parallel) continue;
      if (std::abs(d / far - 1) < 0x1p-20) continue;
      const bool expected = d > 0 && d < far;
      for (int x = 40; x < 120; ++x)
        EXPECT_EQ(frame.color_row(3, y)[x] != 0, expected) << x << ' ' << y << ", distance " << d;
      (expected ? drawn : beyond) += 1;
    }
    EXPECT_GT(drawn, 10) << parallel;
    EXPECT_GT(beyond, 10) << parallel;
  }
}

TEST(DepthBuffer, RefusesPlanesThatItCannotTellApart) {
  Scene scene = pyramid_to_cube(64, 48);
  scene.image.depth_format = DepthFormat::fixed24;
  scene.timeline.camera.projection = Perspective{45, 1, 1 + 1e-9};
  EXPECT_THROW(plan_frame(scene, 0), Error);
  scene.timeline.camera.projection = Orthographic{-1, 1, -1, 1, 0, 1e32};
  EXPECT_THROW(plan_frame(scene, 0), Error);
  scene.image.depth_format = DepthFormat::reversed_float;
  EXPECT_NO_THROW(plan_frame(scene, 0));
}

}  // namespace
}  // namespace morphcl::test
