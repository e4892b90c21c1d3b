// Thumbnails, the font, contact sheets and their PNG files.
#include <gtest/gtest.h>
#include <half.h>
#include <png.h>

#include <cmath>
#include <limits>
#include <thread>

#include "host/image/contact_sheet.hpp"
#include "host/image/exposure.hpp"
#include "host/image/png_encode.hpp"
#include "host/image/srgb.hpp"
#include "morphcl/error.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {

static void PrintTo(const Rgb& c, std::ostream* stream) {
  *stream << "(" << int{c.red} << " " << int{c.green} << " " << int{c.blue} << ")";
}

namespace {

using namespace image_test;
using namespace test_support;

RgbImage read_png(const std::string& path) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, path.c_str()) == 0) throw std::runtime_error(header.message);
  EXPECT_EQ(header.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  RgbImage image(static_cast<int>(header.width), static_cast<int>(header.height), {});
  if (png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(header.message);
  return image;
}

TEST(Png, ComesBackAndIsTheSameEveryTime) {
  const TemporaryFolder folder;
  RgbImage image(37, 11, {1, 2, 3});
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i * 7),
                       static_cast<std::uint8_t>(i * 31)};
  write_png(folder / "a.png", image);
  write_png(folder / "b.png", image);
  const RgbImage read = read_png(folder / "a.png");
  ASSERT_EQ(read.width, 37);
  ASSERT_EQ(read.height, 11);
  EXPECT_EQ(read.pixels, image.pixels);
  EXPECT_EQ(bytes_of(folder / "a.png"), bytes_of(folder / "b.png"));
  EXPECT_THROW(write_png("/proc/nope/a.png", image), Error);
}

// 10 x 9 blocks, cut off on the right and below; rows of blocks that are blank wholly, in part and not at all. Its
// blank blocks hold `with`.
FrameBuffer partly_blank_frame(std::uint16_t with) {
  FrameBuffer frame = arbitrary_frame(150, 140, {Channel::color, Channel::depth});
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 10; ++x)
      if (y < 3 || y == 8 || (y % 2 == 0 && x % 3 != 0)) make_blank(frame, x, y, with);
  return frame;
}

TEST(Png, OfAFrameOverAColourIsItsPicture) {
  std::vector<FrameBuffer> frames;
  for (const auto& [width, height] : {std::pair{1, 1}, {37, 11}, {64, 16}, {129, 50}})
    for (const bool noise : {false, true})
      frames.push_back(noise ? arbitrary_frame(width, height, {Channel::color}) : disc_frame(width, height));
  frames.push_back(partly_blank_frame(0x3c01));
  frames.push_back(FrameBuffer(40, 64, {Channel::color, Channel::depth}));
  const TemporaryFolder folder;
  std::vector<char> bytes;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const double stops : {0.0, 1.0, -3.0}) {  // whole ones: the product is exact in both
      encode_png_over(bytes, frames[i], picture_background, Exposure(stops));
      test_support::write_bytes(folder / "a.png", bytes);
      const RgbImage read = read_png(folder / "a.png");
      ASSERT_EQ(read.width, frames[i].width());
      ASSERT_EQ(read.height, frames[i].height());
      EXPECT_EQ(read.pixels, thumbnail(frames[i], {frames[i].width(), frames[i].height()}, exposure_gain(stops)).pixels)
          << "frame " << i << ", " << stops << " stops";
    }
  }
  EXPECT_THROW(encode_png_over(bytes, FrameBuffer(4, 4, {Channel::depth}), picture_background), Error);
}

TEST(Thumbnail, BlankBlocksAreBackgroundWhateverTheirMemoryHolds) {
  const FrameBuffer marked = partly_blank_frame(0x3c01);
  FrameBuffer plain = partly_blank_frame(0);
  plain.data();  // nothing counts as blank any more
  for (const auto& [width, height] : {std::pair{150, 140}, {149, 70}, {31, 29}, {9, 3}, {1, 1}})
    EXPECT_EQ(thumbnail(marked, {width, height}).pixels, thumbnail(plain, {width, height}).pixels)
        << width << " x " << height;
}

TEST(Thumbnail, SizeKeepsProportionsAndNeverGrows) {
  const struct {
    PictureSize frame, box, expected;
  } cases[] = {{{1920, 1080}, {320, 320}, {320, 180}}, {{1080, 1920}, {320, 320}, {180, 320}},
               {{64, 48}, {320, 320}, {64, 48}},       {{16384, 1}, {192, 192}, {192, 1}},
               {{1, 16384}, {192, 192}, {1, 192}},     {{1, 1}, {192, 192}, {1, 1}}};
  for (const auto& [frame, box, expected] : cases) {
    const PictureSize size = fitted_size(frame, box);
    EXPECT_EQ(size.width, expected.width) << frame.width << " x " << frame.height;
    EXPECT_EQ(size.height, expected.height) << frame.width << " x " << frame.height;
  }
}

TEST(Thumbnail, UniformFramesStayUniformAtEverySize) {
  const FrameBuffer frame = uniform_frame(97, 61, 0.25f, 0.5f, 0.75f, 1.0f);
  const Rgb expected{srgb8(0.25f), srgb8(0.5f), srgb8(0.75f)};
  for (const auto& [width, height] : {std::pair{97, 61}, {96, 60}, {50, 31}, {13, 7}, {1, 1}, {97, 1}, {1, 61}}) {
    const RgbImage image = thumbnail(frame, {width, height});
    for (const Rgb& pixel : image.pixels) ASSERT_EQ(pixel, expected) << width << " x " << height;
  }
}

// The mean is taken of light: black and white alternating are 0.5, which is code 188 and not 128.
TEST(Thumbnail, MeanIsLinear) {
  FrameBuffer frame = uniform_frame(64, 64, 0, 0, 0, 1);
  for (int y = 0; y < 64; ++y)
    for (int x = y % 2; x < 64; x += 2)
      for (int channel = 0; channel < 3; ++channel)
        frame.color_row(channel, y)[static_cast<std::size_t>(x)] = half(1.0f).bits();
  for (const Rgb& pixel : thumbnail(frame, {8, 8}).pixels) ASSERT_EQ(pixel, (Rgb{188, 188, 188}));
}

// 3 pixels onto 2: the middle one is shared half and half.
TEST(Thumbnail, PixelsOnABorderAreShared) {
  FrameBuffer frame = uniform_frame(3, 1, 0, 0, 0, 1);
  frame.color_row(0, 0)[1] = half(0.75f).bits();
  const RgbImage image = thumbnail(frame, {2, 1});
  EXPECT_EQ(image.at(0, 0).red, srgb8(0.25f));  // (0 + 0.75 / 2) / 1.5
  EXPECT_EQ(image.at(1, 0).red, srgb8(0.25f));
}

TEST(Thumbnail, LiesOverTheBackground) {
  EXPECT_EQ(thumbnail(uniform_frame(4, 4, 0, 0, 0, 0), {2, 2}).at(1, 1), picture_background);
  EXPECT_EQ(thumbnail(uniform_frame(4, 4, 0, 0, 0, 1), {2, 2}).at(1, 1), (Rgb{0, 0, 0}));
  // Premultiplied: half covered by white.
  const float background = std::pow((picture_background.red / 255.0f + 0.055f) / 1.055f, 2.4f);
  EXPECT_EQ(thumbnail(uniform_frame(4, 4, 0.5f, 0.5f, 0.5f, 0.5f), {2, 2}).at(0, 0).red,
            srgb8(0.5f + 0.5f * background));
}

TEST(Thumbnail, NansAndInfinitiesStayInTheirPixel) {
  FrameBuffer frame = uniform_frame(4, 1, 0.5f, 0.5f, 0.5f, 1);
  frame.color_row(0, 0)[0] = 0x7e00;  // NaN
  frame.color_row(0, 0)[3] = 0x7c00;  // infinity
  const RgbImage image = thumbnail(frame, {2, 1});
  EXPECT_EQ(image.at(0, 0), (Rgb{srgb8(0.25f), srgb8(0.5f), srgb8(0.5f)}));
  EXPECT_EQ(image.at(1, 0), (Rgb{255, srgb8(0.5f), srgb8(0.5f)}));
}

TEST(Thumbnail, FrameWithoutColourIsRefused) {
  EXPECT_THROW(thumbnail(FrameBuffer(4, 4, {Channel::depth}), {2, 2}), Error);
}

std::string drawn(std::string_view text, int width) {
  RgbImage image(width, glyph_height, {0, 0, 0});
  draw_text(image, 0, 0, 1, text, {255, 255, 255});
  std::string rows;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < width; ++x) rows += image.at(x, y).red ? '#' : '.';
    rows += '\n';
  }
  return rows;
}

TEST(Font, DigitsAreReadable) {
  EXPECT_EQ(drawn("-17", 18),
            "........#...#####.\n"
            ".......##.......#.\n"
            "........#......#..\n"
            "#####...#.....#...\n"
            "........#....#....\n"
            "........#....#....\n"
            ".......###...#....\n");
  std::set<std::string> all;
  for (const char* c : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "-"}) all.insert(drawn(c, glyph_width));
  EXPECT_EQ(all.size(), 11u);
}

TEST(Font, IsBlankOutsideItsCellsAndForOtherCharacters) {
  for (const char character : {' ', '\n', '\xff', '#'})
    EXPECT_EQ(drawn({&character, 1}, glyph_width).find('#'), std::string::npos);
  EXPECT_FALSE(glyph_dot('H', -1, 0));
  EXPECT_FALSE(glyph_dot('H', glyph_width, 0));
  EXPECT_FALSE(glyph_dot('H', 0, glyph_height));
  EXPECT_TRUE(glyph_dot('h', 0, 0));
}

TEST(Font, OutsideOfTheImageIsLeftOut) {
  RgbImage image(3, 3, {9, 9, 9});
  draw_text(image, -4, -4, 3, "88888", {255, 0, 0});
  draw_text(image, 100, 100, 2, "1", {255, 0, 0});
  EXPECT_EQ(image.pixels.size(), 9u);
}

std::size_t count(const RgbImage& image, const Rgb& color) {
  std::size_t found = 0;
  for (const Rgb& pixel : image.pixels) found += pixel == color;
  return found;
}

TEST(ContactSheet, ShowsEveryFrameInItsCellWhateverTheOrder) {
  const std::vector<std::int64_t> frames{-2, 0, 3, 4, 7};
  const auto shade = [](std::int64_t frame) { return 0.1f + 0.05f * static_cast<float>(frame + 2); };
  ContactSheet forwards(frames, {32, 18}), backwards(frames, {32, 18});
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::int64_t first = frames[i], last = frames[frames.size() - 1 - i];
    forwards.add(first, uniform_frame(32, 18, shade(first), 0, 0, 1));
    backwards.add(last, uniform_frame(32, 18, shade(last), 0, 0, 1));
  }
  EXPECT_EQ(forwards.image().pixels, backwards.image().pixels);
  for (const std::int64_t frame : frames)
    EXPECT_EQ(count(forwards.image(), {srgb8(shade(frame)), 0, 0}), 32u * 18u) << "frame " << frame;
}

TEST(ContactSheet, MayBeFilledByManyThreads) {
  std::vector<std::int64_t> frames;
  for (int frame = 0; frame < 40; ++frame) frames.push_back(frame);
  ContactSheet together(frames, {64, 36}), alone(frames, {64, 36});
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&, t] {
        for (int frame = t; frame < 40; frame += 4) together.add(frame, arbitrary_frame(64, 36, {Channel::color}, 5));
      });
  }
  for (const std::int64_t frame : frames) alone.add(frame, arbitrary_frame(64, 36, {Channel::color}, 5));
  EXPECT_EQ(together.image().pixels, alone.image().pixels);
}

TEST(ContactSheet, MissingFramesHaveRedNumbers) {
  ContactSheet sheet({1, 8}, {32, 18});
  const Rgb red{225, 80, 70};
  const std::size_t both = count(sheet.image(), red);
  sheet.add(1, uniform_frame(32, 18, 1, 1, 1, 1));
  const std::size_t one = count(sheet.image(), red);
  sheet.add(8, uniform_frame(32, 18, 1, 1, 1, 1));
  EXPECT_GT(both, one);
  EXPECT_GT(one, 0u);
  EXPECT_EQ(count(sheet.image(), red), 0u);
}

TEST(ContactSheet, LongSequencesShowEveryNth) {
  std::vector<std::int64_t> frames(1'000'000);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = static_cast<std::int64_t>(i);
  const ContactSheet sheet(frames, {1920, 1080});
  std::size_t shown = 0;
  for (std::int64_t frame = 0; frame < 1'000'000; frame += 500) shown += sheet.shows(frame);
  EXPECT_EQ(shown, ContactSheet::max_cells);
  EXPECT_FALSE(sheet.shows(1));
  EXPECT_LT(sheet.image().width * sheet.image().height, 32'000'000);
}

TEST(ContactSheet, OddFramesAreNoTrouble) {
  ContactSheet sheet({5}, {16384, 1});
  sheet.add(5, uniform_frame(16384, 1, 1, 1, 1, 1));
  sheet.add(6, uniform_frame(16384, 1, 1, 1, 1, 1));  // not of the sheet
  sheet.add(5, uniform_frame(40, 4000, 1, 0, 0, 1));  // of another size
  EXPECT_GE(sheet.image().width, 480);
  EXPECT_THROW(sheet.add(5, FrameBuffer(4, 4, {Channel::depth})), Error);
}

}  // namespace
}  // namespace morphcl
