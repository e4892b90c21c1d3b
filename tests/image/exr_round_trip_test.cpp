// What is written comes back: pixels bit for bit, attributes, and the same bytes every time.
#include <gtest/gtest.h>

#include <tuple>

#include "host/image/exr_encode.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/channel_sets.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

const std::vector<std::string> lossless{"none", "rle", "zips", "zip", "zip:small", "piz"};
const std::vector<std::string> lossy{"pxr24", "b44", "b44a", "dwaa", "dwab"};

FrameAttributes some_attributes() {
  FrameAttributes attributes;
  attributes.frame = 57;
  attributes.fps_numerator = 24000;
  attributes.fps_denominator = 1001;
  attributes.fingerprint = "0123456789abcdef0123456789abcdef";
  return attributes;
}

using Shape = std::tuple<int, int, ChannelSet>;
const std::vector<Shape> shapes{{1, 1, default_channels},   {63, 1, color_alone},   {1, 300, depth_alone},
                                {65, 33, default_channels}, {257, 70, depth_alone}, {128, 64, color_alone}};

TEST(ExrRoundTrip, LosslessCompressionsKeepEveryBit) {
  const TemporaryFolder folder;
  for (const std::string& compression : lossless)
    for (const auto& [width, height, channels] : shapes) {
      SCOPED_TRACE(testing::Message() << compression << " " << width << " x " << height);
      const FrameBuffer frame = arbitrary_frame(width, height, channels);
      const std::string path = folder / "frame.exr";
      const std::string hash = write_exr(path, frame, some_attributes(), compression);
      const ExrFrame read = read_exr(path);
      EXPECT_EQ(difference(frame, read.frame), "");
      EXPECT_EQ(hash, pixel_hash(frame));
      EXPECT_EQ(read.stored_hash, hash);
      EXPECT_EQ(read.hash, hash);
      EXPECT_TRUE(is_finished_frame(path, some_attributes().fingerprint));
    }
}

// The hash in the file is that of what a reader gets, so a resumed job can trust these files too.
TEST(ExrRoundTrip, LossyCompressionsStoreTheHashOfWhatTheyGiveBack) {
  const TemporaryFolder folder;
  for (const std::string& compression : lossy)
    for (const auto& [width, height] : {std::pair{65, 33}, {128, 300}}) {
      SCOPED_TRACE(testing::Message() << compression << " " << width << " x " << height);
      const std::string path = folder / "frame.exr";
      const std::string hash = write_exr(path, disc_frame(width, height), some_attributes(), compression);
      EXPECT_EQ(read_exr(path).hash, hash);
      EXPECT_TRUE(is_finished_frame(path, some_attributes().fingerprint));
    }
}

TEST(ExrRoundTrip, AllNamesAreCovered) {
  std::vector<std::string> names = lossless;
  names.insert(names.end(), lossy.begin(), lossy.end());
  EXPECT_EQ(compression_names(), names);
}

TEST(ExrRoundTrip, UnknownCompressionIsAUsageErrorThatListsThem) {
  try {
    check_compression("jpeg");
    FAIL() << "jpeg was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("none, rle, zips, zip, zip:small, piz"), std::string::npos)
        << error.what();
  }
  const TemporaryFolder folder;
  EXPECT_THROW(write_exr(folder / "a.exr", disc_frame(4, 4), {}, "jpeg"), Error);
  EXPECT_TRUE(folder.names().empty());
}

TEST(ExrRoundTrip, FrameWithoutChannelsIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_exr(folder / "a.exr", FrameBuffer(4, 4, {}), {}, "zip"), Error);
  EXPECT_TRUE(folder.names().empty());
}

TEST(ExrRoundTrip, SameFrameGivesSameBytesWhateverTheThreads) {
  const FrameBuffer frame = disc_frame(300, 200);
  for (const std::string& compression : compression_names()) {
    std::vector<char> first, second, third;
    encode_exr(first, frame, some_attributes(), compression, 1);
    encode_exr(second, frame, some_attributes(), compression, 1);
    encode_exr(third, frame, some_attributes(), compression, 4);
    EXPECT_EQ(first, second) << compression;
    EXPECT_EQ(first, third) << compression << " with 4 threads";
  }
}

TEST(ExrRoundTrip, BytesHoldNoFolderAndNoPadding) {
  const TemporaryFolder folder;
  FrameBuffer frame = disc_frame(70, 70);
  write_exr(folder / "a.exr", frame, some_attributes(), "none");
  frame.color_row(2, 3).data()[70] = 0xdead;                                               // right of the image
  std::fill_n(frame.data() + 70 * frame.row_bytes(), frame.row_bytes(), std::byte{0x77});  // below it
  std::filesystem::create_directory(folder / "elsewhere");
  write_exr(folder / "elsewhere/b.exr", frame, some_attributes(), "none");
  EXPECT_EQ(bytes_of(folder / "a.exr"), bytes_of(folder / "elsewhere/b.exr"));
}

TEST(ExrRoundTrip, AttributesComeBack) {
  const TemporaryFolder folder;
  FrameAttributes attributes = some_attributes();
  attributes.frame = -1'000'000;
  // Binary fractions, so that the file's floats hold them.
  attributes.world_to_eye = glm::dmat4{0.5, 0, 0.25, 0, 0, 1, 0, 0, -0.25, 0, 0.5, 0, 3, -2, -7, 1};
  attributes.world_to_ndc = glm::dmat4{1.5, 0, 2, 0.25, 0, 2, 0, 0, 1, 0, 0.5, -1, 3, -2, -7, 4};
  write_exr(folder / "a.exr", disc_frame(8, 8), attributes, "rle");
  const FrameAttributes read = read_exr(folder / "a.exr").attributes;
  EXPECT_EQ(read.frame, attributes.frame);
  EXPECT_EQ(read.fps_numerator, 24000);
  EXPECT_EQ(read.fps_denominator, 1001);
  EXPECT_EQ(read.fingerprint, attributes.fingerprint);
  EXPECT_EQ(read.world_to_eye, attributes.world_to_eye);
  EXPECT_EQ(read.world_to_ndc, attributes.world_to_ndc);
}

}  // namespace
}  // namespace morphcl
