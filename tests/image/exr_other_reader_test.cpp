// OpenImageIO's oiiotool reads the files as meant, and writes them again without a changed pixel.
#include <gtest/gtest.h>
#include <stdio.h>

#include "morphcl/exr.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/image/test_frames.hpp"

namespace morphcl {
namespace {

using namespace image_test;

struct Outcome {
  int status;
  std::string text;
};
Outcome oiiotool(const std::string& arguments) {
  FILE* pipe = popen((std::string(MORPHCL_OIIOTOOL) + " " + arguments + " 2>&1").c_str(), "r");
  Outcome outcome{-1, ""};
  char line[512];
  while (pipe && fgets(line, sizeof line, pipe)) outcome.text += line;
  if (pipe) outcome.status = pclose(pipe);
  return outcome;
}

TEST(OtherReader, ShowsTheAttributes) {
  const TemporaryFolder folder;
  FrameAttributes attributes;
  attributes.frame = 57;
  attributes.fps_numerator = 24000;
  attributes.fps_denominator = 1001;
  attributes.fingerprint = "0123456789abcdef";
  const std::string hash = write_exr(folder / "a.exr", disc_frame(64, 48), attributes, "zip");
  const Outcome info = oiiotool("--info -v " + (folder / "a.exr"));
  EXPECT_EQ(info.status, 0);
  for (const std::string& line :
       {std::string("64 x   48, 5 channel, half/half/half/half/float openexr"),
        std::string("channel list: R (half), G (half), B (half), A (half), Z (float)"),
        std::string("compression: \"zip\""), std::string("framesPerSecond: 24000/1001"),
        std::string("imageCounter: 57"), std::string("smpte:TimeCode: 00:00:02:09"),
        std::string("morphclFingerprint: \"0123456789abcdef\""), "pixelHash: \"" + hash + "\"",
        std::string("worldToCamera: 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1"),
        std::string("worldToNDC: 0.5, 0, 0, 0, 0, -0.5, 0, 0, 0, 0, 1, 0, 0.5, 0.5, 0, 1")})
    EXPECT_NE(info.text.find(line), std::string::npos) << line << "\nnot in\n" << info.text;
}

TEST(OtherReader, WritesTheSamePixelsAgain) {
  const TemporaryFolder folder;
  for (const char* compression : {"none", "rle", "zips", "zip", "zip:small", "piz"}) {
    const FrameBuffer frame = disc_frame(130, 70);
    const std::string hash = write_exr(folder / "a.exr", frame, {}, compression);
    const Outcome copy = oiiotool((folder / "a.exr") + " -o " + (folder / "b.exr"));
    ASSERT_EQ(copy.status, 0) << copy.text;
    const ExrFrame read = read_exr(folder / "b.exr");
    EXPECT_EQ(difference(frame, read.frame), "") << compression;
    EXPECT_EQ(read.hash, hash) << compression;
  }
}

TEST(OtherReader, TakesTheSamePixelsFromEveryLosslessCompression) {
  const TemporaryFolder folder;
  std::string first;
  for (const char* compression : {"none", "rle", "zips", "zip", "zip:small", "piz"}) {
    write_exr(folder / "a.exr", disc_frame(130, 70), {}, compression);
    const Outcome hash = oiiotool("--hash " + (folder / "a.exr"));
    ASSERT_EQ(hash.status, 0) << hash.text;
    const std::size_t sha = hash.text.find("SHA-1:");
    ASSERT_NE(sha, std::string::npos) << hash.text;
    if (first.empty()) first = hash.text.substr(sha);
    EXPECT_EQ(hash.text.substr(sha), first) << compression;
  }
}

}  // namespace
}  // namespace morphcl
