// OpenImageIO's oiiotool reads the files as meant, and writes them again without a changed pixel.
#include <gtest/gtest.h>

#include "host/image/channel_planes.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

// `out` has what it printed on both streams.
ProcessResult oiiotool(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {MORPHCL_OIIOTOOL};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command, {.standard_error = StandardError::with_stdout});
}

TEST(OtherReader, ShowsTheAttributes) {
  const TemporaryFolder folder;
  FrameAttributes attributes;
  attributes.frame = 57;
  attributes.fps_numerator = 24000;
  attributes.fps_denominator = 1001;
  attributes.fingerprint = "0123456789abcdef";
  const std::string hash = write_exr(folder / "a.exr", disc_frame(64, 48), attributes, "zip");
  const ProcessResult info = oiiotool({"--info", "-v", folder / "a.exr"});
  EXPECT_EQ(info.code, 0);
  for (const std::string& line :
       {std::string("64 x   48, 5 channel, half/half/half/half/float openexr"),
        std::string("channel list: R (half), G (half), B (half), A (half), Z (float)"),
        std::string("compression: \"zip\""), std::string("framesPerSecond: 24000/1001"),
        std::string("imageCounter: 57"), std::string("smpte:TimeCode: 00:00:02:09"),
        std::string("morphclFingerprint: \"0123456789abcdef\""), "pixelHash: \"" + hash + "\"",
        std::string("worldToCamera: 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1"),
        std::string("worldToNDC: 0.5, 0, 0, 0, 0, -0.5, 0, 0, 0, 0, 1, 0, 0.5, 0.5, 0, 1")})
    EXPECT_NE(info.out.find(line), std::string::npos) << line << "\nnot in\n" << info.out;
}

TEST(OtherReader, WritesTheSamePixelsAgain) {
  const TemporaryFolder folder;
  for (const char* compression : {"none", "rle", "zips", "zip", "zip:small", "piz"}) {
    const FrameBuffer frame = disc_frame(130, 70);
    const std::string hash = write_exr(folder / "a.exr", frame, {}, compression);
    const ProcessResult copy = oiiotool({folder / "a.exr", "-o", folder / "b.exr"});
    ASSERT_EQ(copy.code, 0) << copy.out;
    const ExrFrame read = read_exr(folder / "b.exr");
    EXPECT_EQ(difference(frame, read.frame), "") << compression;
    EXPECT_EQ(read.hash, hash) << compression;
  }
}

// Every plane of every channel by its name and type, and oiiotool's copy of the file holds the same bits.
TEST(OtherReader, ReadsEveryChannel) {
  const TemporaryFolder folder;
  for (const ChannelNames names : {ChannelNames::plain, ChannelNames::blender, ChannelNames::nuke}) {
    FrameAttributes attributes;
    attributes.channel_names = names;
    attributes.manifests = std::make_shared<CryptomatteManifests>(R"({"bunny":"13851a76"})", "{}");
    const FrameBuffer frame = disc_frame(130, 70, every_channel);
    write_exr(folder / "a.exr", frame, attributes);
    const ProcessResult info = oiiotool({"--info", "-v", folder / "a.exr"});
    ASSERT_EQ(info.code, 0) << info.out;
    for (const NamedPlane& plane : named_planes(every_channel, names)) {
      const char* const types[] = {"uint", "half", "float"};
      const std::string expected = plane.name + " (" + types[static_cast<int>(plane_type(plane.channel))] + ")";
      EXPECT_NE(info.out.find(expected), std::string::npos) << expected << "\nnot in\n" << info.out;
    }
    EXPECT_NE(info.out.find("lin_rec709_scene"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("uint32_to_float32"), std::string::npos) << info.out;

    // oiiotool copies channels of several types by way of float, which numbers do not survive.
    constexpr ChannelSet ids{Channel::object_id, Channel::material_id};
    for (const ChannelSet channels : {ids, every_channel - ids}) {
      const FrameBuffer part = disc_frame(130, 70, channels);
      write_exr(folder / "a.exr", part, attributes);
      const ProcessResult copy = oiiotool({folder / "a.exr", "-o", folder / "b.exr"});
      ASSERT_EQ(copy.code, 0) << copy.out;
      EXPECT_EQ(difference(part, read_exr(folder / "b.exr").frame), "") << name_of(names);
    }
  }
}

TEST(OtherReader, TakesTheSamePixelsFromEveryLosslessCompression) {
  const TemporaryFolder folder;
  std::string first;
  for (const char* compression : {"none", "rle", "zips", "zip", "zip:small", "piz"}) {
    write_exr(folder / "a.exr", disc_frame(130, 70), {}, compression);
    const ProcessResult hash = oiiotool({"--hash", folder / "a.exr"});
    ASSERT_EQ(hash.code, 0) << hash.out;
    const std::size_t sha = hash.out.find("SHA-1:");
    ASSERT_NE(sha, std::string::npos) << hash.out;
    if (first.empty()) first = hash.out.substr(sha);
    EXPECT_EQ(hash.out.substr(sha), first) << compression;
  }
}

}  // namespace
}  // namespace morphcl
