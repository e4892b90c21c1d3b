// The pictures of docs/projections.md against the geometry of tests/math/picture_reference.hpp: the solid's corners
// through the camera's matrices, and every pixel of the rendered silhouette and distances by a line of sight.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/plan/view_volume.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"
#include "tests/math/picture_reference.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

constexpr const char* drawings[] = {"front",     "back",     "left",      "right",      "top",     "bottom",
                                    "isometric", "dimetric", "trimetric", "cavalier",   "cabinet", "oblique",
                                    "central",   "frustum",  "two_point", "perspective"};

// The cube without its corner (1, 1, 1).
constexpr std::array<glm::dvec3, 10> corners = {{{-1, -1, -1},
                                                 {1, -1, -1},
                                                 {1, 1, -1},
                                                 {-1, 1, -1},
                                                 {-1, -1, 1},
                                                 {1, -1, 1},
                                                 {-1, 1, 1},
                                                 {0, 1, 1},
                                                 {1, 0, 1},
                                                 {1, 1, 0}}};
// The solid is where dot(normal, point) <= offset for all of these.
struct Face {
  glm::dvec3 normal;
  double offset;
};
constexpr std::array<Face, 7> faces = {{{{1, 0, 0}, 1},
                                        {{-1, 0, 0}, 1},
                                        {{0, 1, 0}, 1},
                                        {{0, -1, 0}, 1},
                                        {{0, 0, 1}, 1},
                                        {{0, 0, -1}, 1},
                                        {{1, 1, 1}, 2}}};

class ProjectionPicture : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    scene_ = load_scene(std::string(MORPHCL_DOCS) + "/projections/" + GetParam() + ".toml");
    ASSERT_EQ(scene_.objects.size(), 1u);
    width_ = scene_.image.width;
    height_ = scene_.image.height;
    window_ = reference::picture_window(GetParam(), double{1} * width_ / height_);
  }
  glm::dvec2 pixel_of(const glm::dvec3& corner) const {
    const reference::PicturePoint p = reference::draw_point(GetParam(), corner);
    return {(p.x.high - window_.left) / (window_.right - window_.left) * width_,
            (window_.top - p.y.high) / (window_.top - window_.bottom) * height_};
  }
  // The distance along the view axis at which the line of sight through a point of the picture meets the solid;
  // infinity where it does not.
  double distance_at(double x, double y) const {
    const reference::SightLine line =
        reference::sight_line(GetParam(), window_.left + (window_.right - window_.left) * x / width_,
                              window_.top - (window_.top - window_.bottom) * y / height_);
    double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
    for (const Face& face : faces) {
      const double rate = glm::dot(face.normal, line.direction);
      const double left = face.offset - glm::dot(face.normal, line.origin);
      if (rate == 0 && left < 0) return std::numeric_limits<double>::infinity();
      if (rate < 0) enter = std::max(enter, left / rate);
      if (rate > 0) leave = std::min(leave, left / rate);
    }
    if (enter > leave) return std::numeric_limits<double>::infinity();
    return line.origin_distance + enter * line.distance_per_step;
  }

  Scene scene_;
  int width_ = 0, height_ = 0;
  reference::PictureWindow window_{};
};

// 16u64 for the camera's axes, 8u64 for the projection's entries, and the sums of four products of numbers up to 10
// over a window of at least 2: less than 200 units in NDC.
constexpr double ndc_bound = 200 * reference::u64;

TEST_P(ProjectionPicture, CornersAreWhereGeometryPutsThem) {
  const CameraState camera = evaluate(scene_.timeline, 0).camera;
  const double aspect = double{1} * width_ / height_;
  const glm::dmat4 to_clip = projection_matrix(camera.projection, aspect) * camera.world_to_eye;
  for (const glm::dvec3& corner : corners) {
    const glm::dvec4 clip = to_clip * glm::dvec4(corner, 1);
    const glm::dvec2 actual = Viewport{0, 0, double(width_), double(height_)}.to_pixels(glm::dvec2(clip) / clip.w);
    const glm::dvec2 expected = pixel_of(corner);
    EXPECT_NEAR(actual.x, expected.x, ndc_bound * width_) << corner.x << " " << corner.y << " " << corner.z;
    EXPECT_NEAR(actual.y, expected.y, ndc_bound * height_) << corner.x << " " << corner.y << " " << corner.z;
    const double distance = -(camera.world_to_eye * glm::dvec4(corner, 1)).z;
    EXPECT_NEAR(distance, reference::draw_point(GetParam(), corner).distance.high, 200 * reference::u64);
  }
}

// Vertices are snapped to 1/256 of a pixel: a pixel is not in doubt when its surroundings of 1/128 pixel agree, and its
// distance is one of those there. Between the nine samples an edge of the solid may stand out by as much as they
// differ.
TEST_P(ProjectionPicture, EveryPixelShowsWhatItsLineOfSightMeets) {
  const Plan plan = plan_frame(scene_, 0);
  FrameBuffer picture(width_, height_, {Channel::color, Channel::depth});
  make_reference_renderer()->render(plan, picture);
  int solid = 0, background = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
      for (const double dx : {-1.0 / 128, 0.0, 1.0 / 128})
        for (const double dy : {-1.0 / 128, 0.0, 1.0 / 128}) {
          const double distance = distance_at(x + 0.5 + dx, y + 0.5 + dy);
          nearest = std::min(nearest, distance);
          farthest = std::max(farthest, distance);
        }
      const double actual = double{picture.depth_row(y)[x]};
      if (std::isinf(nearest)) {
        EXPECT_EQ(actual, 1e10f) << x << ", " << y;
        ++background;
      } else if (std::isfinite(farthest)) {
        // Four roundings of fp32 in what is added up to 10 at most.
        constexpr double rounding = 4 * 10 * reference::u32;
        EXPECT_GE(actual, nearest - (farthest - nearest) - rounding) << x << ", " << y;
        EXPECT_LE(actual, farthest + rounding) << x << ", " << y;
        ++solid;
      }
    }
  EXPECT_GT(solid, width_ * height_ / 10);
  EXPECT_GT(background, width_ * height_ / 10);
  EXPECT_GT(solid + background, width_ * height_ * 95 / 100);
}

TEST_P(ProjectionPicture, TheDeviceDrawsTheSameBits) {
  const Plan plan = plan_frame(scene_, 0), complete = plan_frame(scene_, 0, {.leave_out = false});
  FrameBuffer expected(width_, height_, {Channel::color, Channel::depth}),
      device(width_, height_, {Channel::color, Channel::depth}),
      nothing_left_out(width_, height_, {Channel::color, Channel::depth});
  make_reference_renderer()->render(plan, expected);
  make_device_renderer(shared_session())->render(plan, device);
  make_device_renderer(shared_session())->render(complete, nothing_left_out);
  EXPECT_TRUE(same_pixels(expected, device));
  EXPECT_TRUE(same_pixels(expected, nothing_left_out));
}

INSTANTIATE_TEST_SUITE_P(Docs, ProjectionPicture, ::testing::ValuesIn(drawings),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace morphcl::test
