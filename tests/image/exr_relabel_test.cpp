// A relabelled file is what the encoder would have made of the same pixels, byte for byte.
#include "host/image/exr_relabel.hpp"

#include <gtest/gtest.h>

#include "host/image/exr_encode.hpp"
#include "morphcl/error.hpp"
#include "tests/image/test_frames.hpp"

namespace morphcl {
namespace {

using namespace image_test;

TEST(ExrRelabel, GivesTheBytesOfTheEncoder) {
  FrameAttributes before, after;
  before.frame = 3;
  before.fingerprint = "short";
  after.frame = 99;
  after.fps_numerator = 60;  // has no time code
  after.fingerprint = "a longer fingerprint, which moves the chunks";
  after.world_to_eye[3][0] = 7;
  for (const std::string& compression : compression_names()) {
    const FrameBuffer frame = disc_frame(130, 70);
    std::vector<char> source, expected, there, back;
    const std::string hash = encode_exr(source, frame, before, compression, 1);
    encode_exr(expected, frame, after, compression, 1);
    EXPECT_EQ(relabel_exr(there, source, after), hash) << compression;
    EXPECT_EQ(there, expected) << compression;
    EXPECT_EQ(relabel_exr(back, there, before), hash) << compression;
    EXPECT_EQ(back, source) << compression;
  }
}

TEST(ExrRelabel, RefusesWhatIsCutOff) {
  std::vector<char> source, out;
  encode_exr(source, disc_frame(40, 40), {}, "zip", 1);
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{5}, std::size_t{300}})
    EXPECT_THROW(relabel_exr(out, {source.data(), bytes}, {}), Error) << bytes << " bytes";
}

}  // namespace
}  // namespace morphcl
