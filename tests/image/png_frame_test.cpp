// PNG frames: the codes that the rule says, the same bytes whatever the threads, read back by this library and by
// libpng.
#include "morphcl/png.hpp"

#include <gtest/gtest.h>
#include <half.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host/image/png_encode.hpp"
#include "host/image/raw_frame.hpp"
#include "host/image/srgb.hpp"
#include "morphcl/error.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

FrameAttributes attributes_of_job() {
  FrameAttributes attributes;
  attributes.frame = -57;
  attributes.fingerprint = "0123456789abcdef0123456789abcdef";
  return attributes;
}

std::vector<char> encoded_png(const FrameBuffer& frame, int bits, int threads = 1) {
  std::vector<char> bytes;
  encode_png(bytes, frame, attributes_of_job(), bits, threads);
  return bytes;
}

// What libpng makes of a file.
struct Picture {
  int width = 0, height = 0, bits = 0, color = 0, intent = -1;
  double gamma = 0;
  std::vector<std::uint16_t> samples;
  std::vector<PngText> texts;
};

Picture picture_of_libpng(const std::vector<char>& bytes) {
  struct Source {
    const char* at;
    const char* end;
  } source{bytes.data(), bytes.data() + bytes.size()};
  // Without setjmp: an error ends the test program.
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_benign_errors(png, 0);
  png_set_read_fn(png, &source, [](png_structp reader, png_bytep out, png_size_t count) {
    auto* const from = static_cast<Source*>(png_get_io_ptr(reader));
    if (static_cast<png_size_t>(from->end - from->at) < count) png_error(reader, "the file ends");
    std::memcpy(out, from->at, count);
    from->at += count;
  });
  png_read_info(png, info);
  Picture picture;
  picture.width = static_cast<int>(png_get_image_width(png, info));
  picture.height = static_cast<int>(png_get_image_height(png, info));
  picture.bits = png_get_bit_depth(png, info);
  picture.color = png_get_color_type(png, info);
  png_get_sRGB(png, info, &picture.intent);
  png_get_gAMA(png, info, &picture.gamma);
  std::vector<png_byte> line(png_get_rowbytes(png, info));
  for (int y = 0; y < picture.height; ++y) {
    png_read_row(png, line.data(), nullptr);
    for (std::size_t i = 0; i < line.size(); i += static_cast<std::size_t>(picture.bits) / 8)
      picture.samples.push_back(static_cast<std::uint16_t>(picture.bits == 8 ? line[i] : line[i] << 8 | line[i + 1]));
  }
  png_read_end(png, info);
  EXPECT_EQ(source.at, source.end);
  png_textp texts = nullptr;
  const int count = png_get_text(png, info, &texts, nullptr);
  for (int i = 0; i < count; ++i) picture.texts.push_back({texts[i].key, texts[i].text});
  png_destroy_read_struct(&png, &info, nullptr);
  return picture;
}

float value_of(std::uint16_t bits) {
  half value;
  value.setBits(bits);
  return value;
}

// round(max sRGB(linear)) by IEC 61966-2-1, in long double: good for values that are not made to lie on a boundary.
long double code_of(long double linear, int max) {
  linear = std::clamp(linear, 0.0L, 1.0L);
  return std::floor(max * (linear <= 0.0031308L ? 12.92L * linear : 1.055L * std::pow(linear, 1 / 2.4L) - 0.055L) +
                    0.5L);
}

// By the rule, pixel after pixel.
std::vector<std::uint16_t> expected_samples(const FrameBuffer& frame, int bits) {
  const int max = (1 << bits) - 1;
  std::vector<std::uint16_t> samples;
  for (int y = 0; y < frame.height(); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(frame.width()); ++x) {
      const float stored = value_of(frame.color_row(3, y)[x]);
      const long double alpha = stored > 0 ? std::min(stored, 1.0f) : 0.0f;
      for (int channel = 0; channel < 3; ++channel) {
        const long double color = value_of(frame.color_row(channel, y)[x]);
        samples.push_back(static_cast<std::uint16_t>(alpha > 0 && color > 0 ? code_of(color / alpha, max) : 0));
      }
      samples.push_back(static_cast<std::uint16_t>(std::floor(alpha * max + 0.5L)));
    }
  return samples;
}

void expect_codes_of_the_rule(const FrameBuffer& frame, int bits) {
  SCOPED_TRACE(testing::Message() << bits << " bits, " << frame.width() << " x " << frame.height());
  const Picture picture = picture_of_libpng(encoded_png(frame, bits));
  EXPECT_EQ(picture.width, frame.width());
  EXPECT_EQ(picture.height, frame.height());
  EXPECT_EQ(picture.bits, bits);
  EXPECT_EQ(picture.color, PNG_COLOR_TYPE_RGB_ALPHA);
  EXPECT_EQ(picture.samples, expected_samples(frame, bits));
  EXPECT_EQ(picture.intent, PNG_sRGB_INTENT_PERCEPTUAL);
  EXPECT_NEAR(picture.gamma, 0.45455, 1e-9);
}

// Alpha from 0 to more than 1, colours from below 0 to brighter than white.
FrameBuffer glassy_frame(int width, int height) {
  FrameBuffer frame = arbitrary_frame(width, height, {Channel::color});
  for (int y = 0; y < height; ++y)
    for (int channel = 0; channel < 4; ++channel)
      for (std::uint16_t& bits : frame.color_row(channel, y))
        if (bits % 4 != 0) bits = static_cast<std::uint16_t>(0x2c00 + bits % 0x1200);  // 1/16 to 2
  return frame;
}

TEST(PngFrames, LibpngReadsTheCodesOfTheRule) {
  for (const int bits : {8, 16}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {63, 1}, {1, 300}, {65, 33}, {257, 70}})
      expect_codes_of_the_rule(glassy_frame(width, height), bits);
    // Lines like those before, of which there are fewer at the end.
    expect_codes_of_the_rule(uniform_frame(20, 50, 0.5f, 0.25f, 0.125f, 1), bits);
  }
}

TEST(PngFrames, HalfwayValuesGoUp) {
  // 255 12.92 (2.5 / 969) is 8.5.
  FrameBuffer frame(1, 1, {Channel::color});
  frame.color_row(0, 0)[0] = half(2.5f / 1024).bits();
  frame.color_row(3, 0)[0] = half(969.0f / 1024).bits();
  EXPECT_EQ(picture_of_libpng(encoded_png(frame, 8)).samples[0], 9);
  frame.color_row(0, 0)[0] = 0;
  frame.color_row(3, 0)[0] = half(0.5f).bits();
  EXPECT_EQ(picture_of_libpng(encoded_png(frame, 8)).samples[3], 128);
  EXPECT_EQ(picture_of_libpng(encoded_png(frame, 16)).samples[3], 32768);
}

TEST(PngFrames, PixelsAreThoseOfToSrgb8) {
  const FrameBuffer frame = glassy_frame(67, 40);
  const std::vector<std::uint8_t> pixels = to_srgb8(frame);
  EXPECT_EQ(picture_of_libpng(encoded_png(frame, 8)).samples, std::vector<std::uint16_t>(pixels.begin(), pixels.end()));
}

TEST(PngFrames, TextsSayWhatTheFileIsOf) {
  const std::vector<char> bytes = encoded_png(disc_frame(20, 17), 8);
  const Picture picture = picture_of_libpng(bytes);
  const PngDescription read = decode_png(bytes).description;
  ASSERT_EQ(picture.texts.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(picture.texts[i].key, read.texts.at(i).key);
    EXPECT_EQ(picture.texts[i].value, read.texts.at(i).value);
  }
  EXPECT_EQ(read.texts[0].key + " " + read.texts[0].value, "morphclFrame -57");
  EXPECT_EQ(read.texts[1].key + " " + read.texts[1].value, "morphclFingerprint 0123456789abcdef0123456789abcdef");
  EXPECT_EQ(read.texts[2].key + " " + read.texts[2].value, "pixelHash " + read.hash);
  EXPECT_EQ(read.attributes.frame, -57);
  EXPECT_EQ(read.attributes.fingerprint, attributes_of_job().fingerprint);
  EXPECT_EQ(read.stored_hash, read.hash);
  EXPECT_EQ(read.color, "RGBA");
}

TEST(PngFrames, ADeviationIsOneOfTheTexts) {
  FrameAttributes attributes = attributes_of_job();
  attributes.deviation = "Card\xc2\xb2\n: a*b+c";
  std::vector<char> bytes;
  encode_png(bytes, disc_frame(20, 17), attributes, 8, 1);
  EXPECT_EQ(picture_of_libpng(bytes).texts.size(), 4u);
  EXPECT_EQ(decode_png(bytes).description.attributes.deviation, "Card???: a*b+c");
}

// The hash is a contract: other programs compute it.
TEST(PngFrames, HashesAreKnown) {
  FrameBuffer frame(2, 1, {Channel::color});
  frame.color_row(0, 0)[1] = half(0.5f).bits();
  frame.color_row(3, 0)[1] = half(1.0f).bits();
  EXPECT_EQ(decode_png(encoded_png(frame, 8)).description.hash, "20a45e15d54f9c9dd33d620380180b89");
  EXPECT_EQ(decode_png(encoded_png(frame, 16)).description.hash, "3814573d32c792a6d8c03e4cc96fb47c");
}

TEST(PngFrames, PixelsOfCodesComeBack) {
  const TemporaryFolder folder;
  for (const int bits : {8, 16}) {
    const FrameBuffer frame = disc_frame(70, 50, {Channel::color});
    const std::string hash = write_png(folder / "a.png", frame, attributes_of_job(), bits);
    const PngFrame read = read_png(folder / "a.png");
    EXPECT_EQ(read.description.hash, hash);
    EXPECT_EQ(describe_png(folder / "a.png").hash, hash);
    EXPECT_FALSE(read.frame.has_depth());
    EXPECT_EQ(to_srgb8(read.frame), to_srgb8(frame));
    EXPECT_TRUE(finished_png(folder / "a.png", attributes_of_job().fingerprint, bits));
    EXPECT_FALSE(finished_png(folder / "a.png", attributes_of_job().fingerprint, 24 - bits));
    EXPECT_FALSE(finished_png(folder / "a.png", "another", bits));
    EXPECT_NO_THROW(verify_png(folder / "a.png", hash));
  }
  const PngFrame glass = decode_png(encoded_png(uniform_frame(3, 2, 0.25f, 0.125f, 0, 0.25f), 16));
  EXPECT_NEAR(value_of(glass.frame.color_row(0, 1)[2]), 0.25, 1e-3);
  EXPECT_NEAR(value_of(glass.frame.color_row(1, 1)[2]), 0.125, 1e-3);
  EXPECT_NEAR(value_of(glass.frame.color_row(3, 1)[2]), 0.25, 1e-3);
}

TEST(PngFrames, BytesDoNotDependOnThreadsOrOnWhatCameBefore) {
  for (const int bits : {8, 16})
    for (const int height : {5, 16, 33, 260}) {
      const FrameBuffer frame = disc_frame(90, height);
      const std::vector<char> bytes = encoded_png(frame, bits);
      encoded_png(glassy_frame(300, 50), bits);
      EXPECT_EQ(encoded_png(frame, bits), bytes);
      for (const int threads : {2, 3, 40}) EXPECT_EQ(encoded_png(frame, bits, threads), bytes) << threads;
    }
}

// What is known to be blank is not looked at, so it is held against a frame of which nothing is known.
TEST(PngFrames, BlankBlocksAreBackground) {
  for (const auto& [drawn_x, drawn_y] : {std::pair{-1, -1}, {0, 0}, {70, 31}, {70, 47}, {100, 149}, {199, 64}}) {
    SCOPED_TRACE(testing::Message() << "drawn at " << drawn_x << ", " << drawn_y);
    FrameBuffer noted(200, 150, {Channel::color}), unknown(200, 150, {Channel::color});
    const RawFrame notes(noted);
    for (int tile_y = 0; tile_y < noted.tiles_y(); ++tile_y)
      for (int tile_x = 0; tile_x < noted.tiles_x(); ++tile_x) notes.note(tile_x, tile_y) = 0xffff;
    if (drawn_x >= 0) {
      const int bit = drawn_y % 64 / 16 * 4 + drawn_x % 64 / 16;
      notes.note(drawn_x / 64, drawn_y / 64) &= ~(1u << bit);
      for (int channel = 0; channel < 4; ++channel) {
        const std::size_t at =
            static_cast<std::size_t>(drawn_y) * notes.row_bytes + notes.plane_offset(Channel::color, channel);
        const std::uint16_t white = half(1.0f).bits();
        std::memcpy(notes.data + at + 2 * static_cast<std::size_t>(drawn_x), &white, sizeof white);
        unknown.color_row(channel, drawn_y)[static_cast<std::size_t>(drawn_x)] = white;
      }
    }
    for (const int bits : {8, 16})
      for (const int threads : {1, 3}) EXPECT_EQ(encoded_png(noted, bits, threads), encoded_png(unknown, bits));
  }
}

TEST(PngFrames, LabelsOfAnotherFrameLeaveThePixelsAlone) {
  const FrameBuffer frame = disc_frame(60, 70);
  FrameAttributes other = attributes_of_job();
  other.frame = 123456;
  std::vector<char> direct, relabelled;
  const std::string hash = encode_png(direct, frame, other, 8, 1);
  EXPECT_EQ(relabel_png(relabelled, encoded_png(frame, 8), other), hash);
  EXPECT_EQ(relabelled, direct);
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{60}, std::size_t{200}})
    EXPECT_THROW(relabel_png(relabelled, std::span<const char>(direct).first(size), other), Error) << size;
}

TEST(PngFrames, WhatCannotBeStoredIsRefused) {
  const TemporaryFolder folder;
  const auto kind_of_failure = [&](const FrameBuffer& frame, const FrameAttributes& attributes, int bits) {
    try {
      write_png(folder / "a.png", frame, attributes, bits);
    } catch (const Error& error) {
      EXPECT_EQ(error.place(), (folder / "a.png").string());
      return error.kind();
    }
    return ErrorKind::internal;
  };
  EXPECT_EQ(kind_of_failure(disc_frame(4, 4), {}, 12), ErrorKind::usage);
  EXPECT_EQ(kind_of_failure(disc_frame(4, 4, {Channel::depth}), {}, 8), ErrorKind::usage);
  FrameAttributes attributes;
  attributes.fingerprint = std::string("a\0b", 3);
  EXPECT_EQ(kind_of_failure(disc_frame(4, 4), attributes, 8), ErrorKind::usage);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace morphcl
