// Lines of several samples a pixel, and of any width: what they cover, and the same on the device.
#include <gtest/gtest.h>

#include <algorithm>

#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/sample_pictures.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

Scene line_scene(const glm::dvec2& from, const glm::dvec2& to, double width, int samples) {
  SceneBuilder b = flat_picture(24, 16);
  Mesh mesh = polygon({from, to}, 24, 16);
  mesh.edges = {{0, 1}};
  b.add(mesh, Shading::wireframe, place({0, 0, 0}), {1, 1, 1, 1});
  b.scene().objects[0].material.line_width = width;
  b.scene().image.samples = samples;
  return b.scene();
}

double total_alpha(const FrameBuffer& frame) {
  double sum = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) sum += alpha(frame, x, y);
  return sum;
}

TEST(SampleLines, AlongPixelsCoverTheirWidthExactly) {
  const auto reference = make_reference_renderer();
  for (const int samples : sample_counts)
    for (const bool upright : {false, true})
      for (const int width : {1, 2, 5}) {
        // From middle to middle of pixels across, whole pixels along.
        const double middle = width % 2 == 1 ? 6.5 : 7;
        const Scene scene = upright ? line_scene({middle, 2}, {middle, 12}, width, samples)
                                    : line_scene({2, middle}, {12, middle}, width, samples);
        const FrameBuffer frame = drawn(*reference, scene);
        EXPECT_EQ(total_alpha(frame), 10 * width) << samples << " " << width << " " << upright;
        EXPECT_EQ(upright ? alpha(frame, 6, 5) : alpha(frame, 5, 6), 1);
      }
}

// However a line lies, it covers its length times its width, less or more what the pattern cannot tell.
TEST(SampleLines, CoverLengthTimesWidth) {
  const auto reference = make_reference_renderer();
  test_support::Random random(80);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 from = random_point(random, {4, 4}, {20, 12});
    const glm::dvec2 to = random_point(random, {4, 4}, {20, 12});
    const double length = glm::length(to - from), width = random.in(0.5, 3);
    const glm::dvec2 d = glm::abs(to - from);
    if (length < 1) continue;
    const double covered = total_alpha(drawn(*reference, line_scene(from, to, width, 16)));
    // Its ends are cut along the shorter axis, which leaves the area as it is. Sixteen samples miss an area by at most
    // a sixteenth of a pixel for each pixel of the outline, and less on the mean; the thickness is rounded to 1/256.
    const double outline = 2 * (std::max(d.x, d.y) + width * length / std::max(d.x, d.y)) + 4;
    EXPECT_NEAR(covered, length * width, outline / 16 + length / 128) << i;
  }
}

TEST(SampleLines, AreTheSameOnTheDevice) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const double width : {0.3, 1.0, 2.5, 40.0})
    for (const int samples : sample_counts)
      for (const bool perspective : {false, true}) {
        SceneBuilder b(150, 100);
        b.add(make_torus({9, 7}), Shading::wireframe, place({0, 0, 0}));
        b.add(make_grid({3, 3}), Shading::wireframe, place({0, -0.5, 0}, 20), {0.2, 0.9, 0.4, 1});  // to behind the eye
        b.add(make_cube(), Shading::flat, place({0.5, 0.2, 0}, 0.3));
        b.look({1, 1, 3});
        if (!perspective) b.project(Orthographic{});
        for (Object& object : b.scene().objects) object.material.line_width = width;
        const Scene scene = with_samples(b.scene(), samples);
        EXPECT_TRUE(same_pixels(drawn(*reference, scene), drawn(*device, scene))) << width << " " << samples;
      }
}

}  // namespace
}  // namespace morphcl::test
