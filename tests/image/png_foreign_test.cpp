// PNG files of other tools: described, read where they are RGBA, and of no job.
#include <gtest/gtest.h>
#include <png.h>

#include <cstring>

#include "lab/accuracy/random.hpp"
#include "morphcl/error.hpp"
#include "morphcl/png.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace test_support;

constexpr int side = 9;

// By libpng. `byte_at`: the bytes of the samples, line after line.
template <class ByteAt>
std::vector<char> png_by_libpng(int color, int bits, bool interlaced, int filters, const ByteAt& byte_at) {
  std::vector<char> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp writer, png_bytep data, png_size_t count) {
        auto& out = *static_cast<std::vector<char>*>(png_get_io_ptr(writer));
        out.insert(out.end(), data, data + count);
      },
      nullptr);
  png_set_IHDR(png, info, side, side, bits, color, interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, filters);
  std::array<png_color, 2> palette{{{0, 0, 0}, {255, 255, 255}}};
  if (color == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), palette.size());
  std::array<char, 8> key{"Comment"}, value{"caf\xe9"};
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = key.data();
  text.text = value.data();
  text.text_length = 4;
  png_set_text(png, info, &text, 1);
  png_write_info(png, info);
  std::vector<png_byte> line(png_get_rowbytes(png, info));
  for (int pass = png_set_interlace_handling(png); pass > 0; --pass)
    for (std::size_t y = 0; y < side; ++y) {
      for (std::size_t i = 0; i < line.size(); ++i)
        line[i] =
            color == PNG_COLOR_TYPE_PALETTE ? std::uint8_t{0} : static_cast<std::uint8_t>(byte_at(y * line.size() + i));
      png_write_row(png, line.data());
    }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

int many_values(std::size_t place) { return static_cast<int>(37 * place % 251); }
// Few, so that the Paeth filter has ties to break.
int few_values(std::size_t place) { return 100 + static_cast<int>(accuracy::Random(place).bits() & 3); }

TEST(ForeignPng, EveryKindIsDescribed) {
  const TemporaryFolder folder;
  const struct {
    int color, bits;
    const char* name;
  } kinds[] = {{PNG_COLOR_TYPE_GRAY, 1, "grey"},       {PNG_COLOR_TYPE_GRAY, 16, "grey"},
               {PNG_COLOR_TYPE_PALETTE, 1, "palette"}, {PNG_COLOR_TYPE_PALETTE, 8, "palette"},
               {PNG_COLOR_TYPE_RGB, 8, "RGB"},         {PNG_COLOR_TYPE_GRAY_ALPHA, 8, "grey and alpha"},
               {PNG_COLOR_TYPE_RGB_ALPHA, 8, "RGBA"},  {PNG_COLOR_TYPE_RGB_ALPHA, 16, "RGBA"}};
  for (const auto& [color, bits, name] : kinds)
    for (const bool interlaced : {false, true}) {
      SCOPED_TRACE(testing::Message() << name << ", " << bits << " bits, interlaced " << interlaced);
      write_bytes(folder / "a.png", png_by_libpng(color, bits, interlaced, PNG_ALL_FILTERS, many_values));
      const PngDescription read = describe_png(folder / "a.png");
      EXPECT_EQ(read.width, side);
      EXPECT_EQ(read.height, side);
      EXPECT_EQ(read.bits, bits);
      EXPECT_EQ(read.color, name);
      EXPECT_EQ(read.interlaced, interlaced);
      ASSERT_EQ(read.texts.size(), 1u);
      EXPECT_EQ(read.texts[0].key, "Comment");
      EXPECT_EQ(read.texts[0].value, "caf\xc3\xa9");
      EXPECT_EQ(read.stored_hash, "");
      const bool straight = color == PNG_COLOR_TYPE_RGB_ALPHA && !interlaced;
      EXPECT_EQ(read.hash.empty(), !straight);
      EXPECT_FALSE(finished_png(folder / "a.png", "", bits)) << "of no job, not even of one without a fingerprint";
      try {
        EXPECT_EQ(read_png(folder / "a.png").frame.width(), side);
        EXPECT_TRUE(straight);
      } catch (const Error& error) {
        EXPECT_FALSE(straight) << error.what();
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(error.message().find(name), std::string::npos) << error.message();
      }
    }
}

// Codes of pixels that are not nearly transparent come back as they are.
TEST(ForeignPng, CodesAreThoseThatWereWrittenWithEveryFilter) {
  const TemporaryFolder folder;
  for (const int filters : {PNG_FILTER_NONE, PNG_FILTER_SUB, PNG_FILTER_UP, PNG_FILTER_AVG, PNG_FILTER_PAETH})
    for (const auto& values : {many_values, few_values}) {
      write_bytes(folder / "a.png", png_by_libpng(PNG_COLOR_TYPE_RGB_ALPHA, 8, false, filters, values));
      const std::vector<std::uint8_t> codes = to_srgb8(read_png(folder / "a.png").frame);
      for (std::size_t i = 0; i < codes.size(); i += 4) {
        EXPECT_EQ(codes[i + 3], values(i + 3)) << "filter " << filters << ", pixel " << i / 4;
        for (std::size_t channel = 0; channel < 3 && values(i + 3) > 50; ++channel)
          EXPECT_EQ(codes[i + channel], values(i + channel)) << "filter " << filters << ", pixel " << i / 4;
      }
    }
}

}  // namespace
}  // namespace morphcl
