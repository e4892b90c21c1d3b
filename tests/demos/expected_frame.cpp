#include "tests/demos/expected_frame.hpp"

#include <fmt/format.h>
#include <png.h>

#include <Imath/half.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::viewer_test {
namespace {

std::uint8_t srgb_code(std::uint16_t bits) {
  half value;
  value.setBits(bits);
  const double linear = std::clamp(static_cast<double>(value), 0.0, 1.0);
  const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

}  // namespace

Scene demo_scene(const std::string& shot, int width, int height) {
  LoadOptions options;
  options.width = width;
  options.height = height;
  Scene scene = load_scene(std::string(MORPHCL_TEST_SHOTS) + "/" + shot, options);
  scene.image.width = width;
  scene.image.height = height;
  return scene;
}

FrameBuffer expected_frame(const Scene& scene, std::int64_t frame) {
  FrameBuffer buffer(scene.image.width, scene.image.height, scene.image.channels);
  make_reference_renderer()->render(plan_frame(scene, frame), buffer);
  return buffer;
}

RgbImage srgb_picture(const FrameBuffer& frame) {
  RgbImage picture(frame.width(), frame.height(), Rgb{46, 46, 50});
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      if (frame.color_row(3, y)[x] == 0) continue;
      picture.at(x, y) = {srgb_code(frame.color_row(0, y)[x]), srgb_code(frame.color_row(1, y)[x]),
                          srgb_code(frame.color_row(2, y)[x])};
    }
  }
  return picture;
}

RgbImage read_png(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, path.c_str())) throw std::runtime_error(path + ": " + png.message);
  png.format = PNG_FORMAT_RGB;
  RgbImage image(static_cast<int>(png.width), static_cast<int>(png.height), Rgb{});
  static_assert(sizeof(Rgb) == 3);
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr)) {
    throw std::runtime_error(path + ": " + png.message);
  }
  return image;
}

std::string difference(const RgbImage& actual, const RgbImage& expected, int bound) {
  if (actual.width < expected.width || actual.height < expected.height) {
    return fmt::format("picture of {}x{}, expected {}x{}", actual.width, actual.height, expected.width,
                       expected.height);
  }
  std::string first;
  int count = 0;
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      const Rgb &a = actual.at(x, y), &e = expected.at(x, y);
      const int off = std::max({std::abs(a.red - e.red), std::abs(a.green - e.green), std::abs(a.blue - e.blue)});
      if (off <= bound) continue;
      if (count++ == 0) {
        first = fmt::format("pixel ({}, {}): expected {} {} {}, actual {} {} {}, bound {}", x, y, e.red, e.green,
                            e.blue, a.red, a.green, a.blue, bound);
      }
    }
  }
  return count == 0 ? "" : fmt::format("{}; {} pixels differ", first, count);
}

}  // namespace morphcl::viewer_test
