// Files of other programs: tiles, offset windows, other pixel types, several parts, deep pixels, luminance only.
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>

#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

// A window with a negative origin, 20 x 10 pixels; value(x, y) differs from pixel to pixel and is exact in half.
const Imath::Box2i window({-7, -3}, {12, 6});
constexpr int window_width = 20, window_height = 10;
float value(int x, int y) { return static_cast<float>(x + 32 * y); }

std::vector<float> float_values() {
  std::vector<float> values;
  for (int y = 0; y < window_height; ++y)
    for (int x = 0; x < window_width; ++x) values.push_back(value(x, y));
  return values;
}

Imf::Header header_with(const std::vector<const char*>& channels, Imf::PixelType type) {
  Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), window);
  for (const char* name : channels) header.channels().insert(name, Imf::Channel(type));
  return header;
}

Imf::FrameBuffer slices(const std::vector<const char*>& channels, std::vector<float>& values) {
  Imf::FrameBuffer buffer;
  for (const char* name : channels)
    buffer.insert(name,
                  Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float), window_width * sizeof(float)));
  return buffer;
}

void expect_values(const FrameBuffer& frame, int channel) {
  for (int y = 0; y < window_height; ++y)
    for (int x = 0; x < window_width; ++x)
      ASSERT_EQ(frame.color_row(channel, y)[static_cast<std::size_t>(x)], half(value(x, y)).bits())
          << "at (" << x << ", " << y << ")";
}

ErrorKind kind_of_refusal(const std::string& path) {
  try {
    read_exr(path);
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "was read";
  return ErrorKind::internal;
}

TEST(ForeignExr, FloatColourAtAnOffsetIsReadAsHalf) {
  const TemporaryFolder folder;
  std::vector<float> values = float_values();
  {
    Imf::OutputFile file((folder / "a.exr").c_str(), header_with({"R", "G"}, Imf::FLOAT));
    file.setFrameBuffer(slices({"R", "G"}, values));
    file.writePixels(window_height);
  }
  const ExrFrame read = read_exr(folder / "a.exr");
  ASSERT_EQ(read.frame.width(), window_width);
  ASSERT_EQ(read.frame.height(), window_height);
  EXPECT_FALSE(read.frame.has_depth());
  expect_values(read.frame, 0);
  expect_values(read.frame, 1);
  EXPECT_EQ(read.frame.color_row(2, 0)[5], half(0.0f).bits());  // no B: 0
  EXPECT_EQ(read.frame.color_row(3, 0)[5], half(1.0f).bits());  // no A: opaque
  EXPECT_EQ(read.stored_hash, "");
  EXPECT_FALSE(is_finished_frame(folder / "a.exr", ""));  // of no job, not even of one without a fingerprint
}

TEST(ForeignExr, TilesAreRead) {
  const TemporaryFolder folder;
  std::vector<float> values = float_values();
  {
    Imf::Header header = header_with({"R", "Z"}, Imf::FLOAT);
    header.setTileDescription(Imf::TileDescription(8, 4, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file((folder / "a.exr").c_str(), header);
    file.setFrameBuffer(slices({"R", "Z"}, values));
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  const ExrFrame read = read_exr(folder / "a.exr");
  ASSERT_TRUE(read.frame.has_color() && read.frame.has_depth());
  expect_values(read.frame, 0);
  EXPECT_EQ(read.frame.depth_row(2)[3], value(3, 2));
}

TEST(ForeignExr, FirstOfSeveralPartsIsRead) {
  const TemporaryFolder folder;
  std::vector<float> values = float_values();
  {
    std::vector<Imf::Header> headers{header_with({"R"}, Imf::FLOAT), header_with({"Z"}, Imf::FLOAT)};
    headers[0].setName("first");
    headers[1].setName("second");
    for (Imf::Header& header : headers) header.setType(Imf::SCANLINEIMAGE);
    Imf::MultiPartOutputFile file((folder / "a.exr").c_str(), headers.data(), 2);
    for (int part = 0; part < 2; ++part) {
      Imf::OutputPart output(file, part);
      output.setFrameBuffer(slices({part == 0 ? "R" : "Z"}, values));
      output.writePixels(window_height);
    }
  }
  const ExrFrame read = read_exr(folder / "a.exr");
  expect_values(read.frame, 0);
  EXPECT_FALSE(read.frame.has_depth());
  EXPECT_EQ(describe_exr(folder / "a.exr").parts, 2);
}

TEST(ForeignExr, ImageWithoutOurChannelsIsRefusedAndDescribed) {
  const TemporaryFolder folder;
  std::vector<float> values = float_values();
  {
    Imf::OutputFile file((folder / "a.exr").c_str(), header_with({"Y", "N.W"}, Imf::FLOAT));
    file.setFrameBuffer(slices({"Y", "N.W"}, values));
    file.writePixels(window_height);
  }
  EXPECT_EQ(kind_of_refusal(folder / "a.exr"), ErrorKind::bad_input);
  const ExrDescription description = describe_exr(folder / "a.exr");
  ASSERT_EQ(description.channels.size(), 2u);
  EXPECT_EQ(description.channels[0].name, "N.W");
  EXPECT_EQ(description.channels[0].type, "float");
  EXPECT_EQ(description.data_window.min, glm::ivec2(-7, -3));
}

TEST(ForeignExr, SubsampledColourIsRefused) {
  const TemporaryFolder folder;
  std::vector<float> values = float_values();
  {
    Imf::Header header(Imath::Box2i({0, 0}, {19, 9}), Imath::Box2i({0, 0}, {19, 9}));
    header.channels().insert("R", Imf::Channel(Imf::FLOAT, 2, 2));
    Imf::OutputFile file((folder / "a.exr").c_str(), header);
    Imf::FrameBuffer buffer;
    buffer.insert("R", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                  window_width / 2 * sizeof(float), 2, 2));
    file.setFrameBuffer(buffer);
    file.writePixels(window_height);
  }
  EXPECT_EQ(kind_of_refusal(folder / "a.exr"), ErrorKind::bad_input);
}

TEST(ForeignExr, DeepPixelsAreRefused) {
  const TemporaryFolder folder;
  {
    Imf::Header header = header_with({"Z"}, Imf::FLOAT);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    Imf::DeepScanLineOutputFile file((folder / "a.exr").c_str(), header);
    std::vector<unsigned> counts(window_width * window_height, 1);
    std::vector<float> values = float_values();
    std::vector<float*> samples;
    for (float& v : values) samples.push_back(&v);
    Imf::DeepFrameBuffer buffer;
    const std::ptrdiff_t first = window.min.x + window.min.y * window_width;
    buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data() - first),
                                             sizeof(unsigned), window_width * sizeof(unsigned)));
    buffer.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples.data() - first), sizeof(float*),
                                      window_width * sizeof(float*), sizeof(float)));
    file.setFrameBuffer(buffer);
    file.writePixels(window_height);
  }
  EXPECT_EQ(kind_of_refusal(folder / "a.exr"), ErrorKind::bad_input);
}

}  // namespace
}  // namespace morphcl
