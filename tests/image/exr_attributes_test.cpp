// The attributes as another program sees them: through OpenEXR's own header.
#include "host/image/exr_attributes.hpp"

#include <ImfChannelList.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

Imf::Header written_header(const FrameAttributes& attributes, ChannelSet channels = default_channels) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", disc_frame(40, 30, channels), attributes, "zip");
  return Imf::InputFile((folder / "a.exr").c_str()).header();
}

std::string time_code_at(std::int64_t frame, std::int64_t fps_numerator, std::int64_t fps_denominator = 1) {
  FrameAttributes attributes;
  attributes.frame = frame;
  attributes.fps_numerator = fps_numerator;
  attributes.fps_denominator = fps_denominator;
  const Imf::Header header = written_header(attributes);
  if (!Imf::hasTimeCode(header)) return "none";
  const Imf::TimeCode code = Imf::timeCode(header);
  EXPECT_FALSE(code.dropFrame());
  char text[16];
  std::snprintf(text, sizeof text, "%02d:%02d:%02d:%02d", code.hours(), code.minutes(), code.seconds(), code.frame());
  return text;
}

// A camera at (3, 2, 5) that looks at the origin, 40 degrees high, 4:3.
FrameAttributes some_camera() {
  FrameAttributes attributes;
  attributes.world_to_eye = glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0), glm::dvec3(0, 1, 0));
  attributes.world_to_ndc = glm::perspective(glm::radians(40.0), 4.0 / 3, 0.1, 100.0) * attributes.world_to_eye;
  return attributes;
}

TEST(ExrAttributes, FrameRateNumberAndNames) {
  FrameAttributes attributes;
  attributes.frame = 57;
  attributes.fps_numerator = 30000;
  attributes.fps_denominator = 1001;
  attributes.fingerprint = "fingerprint of the shot";
  const Imf::Header header = written_header(attributes);
  EXPECT_EQ(Imf::framesPerSecond(header).n, 30000);
  EXPECT_EQ(Imf::framesPerSecond(header).d, 1001u);
  EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("imageCounter").value(), 57);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("morphclFingerprint").value(), "fingerprint of the shot");
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("pixelHash").value(), pixel_hash(disc_frame(40, 30)));
}

TEST(ExrAttributes, WindowsAreTheFullImage) {
  const Imf::Header header = written_header({});
  EXPECT_EQ(header.dataWindow(), Imath::Box2i({0, 0}, {39, 29}));
  EXPECT_EQ(header.displayWindow(), header.dataWindow());
  EXPECT_EQ(header.pixelAspectRatio(), 1.0f);
  EXPECT_EQ(header.lineOrder(), Imf::INCREASING_Y);
}

TEST(ExrAttributes, ChromaticitiesAreRec709) {
  const Imf::Chromaticities c = Imf::chromaticities(written_header({}));
  EXPECT_EQ(c.red, Imath::V2f(0.64f, 0.33f));
  EXPECT_EQ(c.green, Imath::V2f(0.30f, 0.60f));
  EXPECT_EQ(c.blue, Imath::V2f(0.15f, 0.06f));
  EXPECT_EQ(c.white, Imath::V2f(0.3127f, 0.3290f));
}

TEST(ExrAttributes, ColourSaysWhichItIsAndOtherChannelsDoNot) {
  for (const ChannelSet channels : {ChannelSet{Channel::color}, ChannelSet{Channel::albedo}, every_channel})
    EXPECT_EQ(text_attribute(written_header({}, channels), "colorInteropID"), "lin_rec709_scene");
  const Imf::Header header = written_header({}, {Channel::depth, Channel::normal, Channel::crypto_object});
  EXPECT_EQ(header.find("colorInteropID"), header.end());
  EXPECT_FALSE(Imf::hasChromaticities(header));
}

TEST(ExrAttributes, ChannelsAreHalfColourAndFloatDepth) {
  const auto channels = [](const Imf::Header& header) {
    std::string text;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
      text += std::string(c.name()) + (c.channel().type == Imf::HALF ? ":half " : ":float ");
    return text;
  };
  EXPECT_EQ(channels(written_header({})), "A:half B:half G:half R:half Z:float ");
  EXPECT_EQ(channels(written_header({}, {Channel::color})), "A:half B:half G:half R:half ");
  EXPECT_EQ(channels(written_header({}, {Channel::depth})), "Z:float ");
}

TEST(ExrAttributes, NothingElseIsStored) {
  std::string names;
  const Imf::Header header = written_header({});
  for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
    names += std::string(attribute.name()) + " ";
  EXPECT_EQ(names,
            "channels chromaticities colorInteropID compression dataWindow displayWindow framesPerSecond imageCounter "
            "lineOrder "
            "morphclFingerprint pixelAspectRatio pixelHash screenWindowCenter screenWindowWidth timeCode worldToCamera "
            "worldToNDC ");
}

// OpenEXR's camera: row vectors, x right, y up, the viewing direction is +z.
TEST(ExrAttributes, WorldToCameraLooksAlongPositiveZ) {
  const Imath::M44f m = Imf::worldToCamera(written_header(some_camera()));
  const Imath::V3f eye = Imath::V3f(3, 2, 5) * m, target = Imath::V3f(0, 0, 0) * m;
  const Imath::V3f above = Imath::V3f(0, 1, 0) * m;
  const float distance = std::sqrt(38.0f);
  constexpr float bound = 16 * 0x1p-24f * 8;  // 16 roundings of values up to 8
  EXPECT_NEAR(eye.length(), 0, bound);
  EXPECT_NEAR(target.x, 0, bound);
  EXPECT_NEAR(target.y, 0, bound);
  EXPECT_NEAR(target.z, distance, bound);
  EXPECT_GT(above.y, 0.5f);
  EXPECT_LT(m.determinant(), 0);  // left-handed
}

// The unit square of the image, (0, 0) in the upper left corner.
TEST(ExrAttributes, WorldToNdcGivesTheUnitSquareFromTheUpperLeft) {
  const FrameAttributes camera = some_camera();
  const Imath::M44f m = Imf::worldToNDC(written_header(camera));
  const glm::dmat4 to_world = glm::inverse(camera.world_to_ndc);
  // Values of up to 100 (far plane) come out of sums of four products, divided by w.
  constexpr float bound = 1e-4f;
  for (const double z : {-0.5, 0.9})
    for (const auto& [x, y, u, v] : {std::tuple{-1.0, 1.0, 0.0f, 0.0f},
                                     {1.0, -1.0, 1.0f, 1.0f},
                                     {1.0, 1.0, 1.0f, 0.0f},
                                     {0.0, 0.5, 0.5f, 0.25f}}) {
      const glm::dvec4 world = to_world * glm::dvec4(x, y, z, 1);
      const Imath::V3f point = Imath::V3f(static_cast<float>(world.x / world.w), static_cast<float>(world.y / world.w),
                                          static_cast<float>(world.z / world.w)) *
                               m;
      EXPECT_NEAR(point.x, u, bound) << "ndc " << x << " " << y << " " << z;
      EXPECT_NEAR(point.y, v, bound) << "ndc " << x << " " << y << " " << z;
    }
}

TEST(ExrAttributes, ScreenWindowIsThatOfThePerspective) {
  const Imf::Header header = written_header(some_camera());
  const float width = static_cast<float>(2 * std::tan(glm::radians(20.0)) * 4 / 3);
  constexpr float rounding = 0x1p-22f;
  EXPECT_NEAR(header.screenWindowWidth(), width, rounding);
  EXPECT_NEAR(header.screenWindowCenter().x, 0, rounding);
  EXPECT_NEAR(header.screenWindowCenter().y, 0, rounding);

  FrameAttributes shifted = some_camera();
  shifted.world_to_ndc = glm::frustum(0.5, 1.5, -0.25, 1.25, 1.0, 10.0) * shifted.world_to_eye;
  const Imf::Header off_axis = written_header(shifted);
  EXPECT_NEAR(off_axis.screenWindowWidth(), 1.0f, rounding);
  EXPECT_NEAR(off_axis.screenWindowCenter().x, 1.0f, rounding);
  EXPECT_NEAR(off_axis.screenWindowCenter().y, 0.5f, rounding);
}

TEST(ExrAttributes, ScreenWindowOfAParallelProjectionIsTheDefault) {
  FrameAttributes attributes = some_camera();
  attributes.world_to_ndc = glm::ortho(-4.0, 4.0, -3.0, 3.0, 0.1, 10.0) * attributes.world_to_eye;
  const Imf::Header header = written_header(attributes);
  EXPECT_EQ(header.screenWindowWidth(), 1.0f);
  EXPECT_EQ(header.screenWindowCenter(), Imath::V2f(0, 0));
}

TEST(ExrAttributes, TimeCodeCountsFramesOfTheRoundedRate) {
  EXPECT_EQ(time_code_at(0, 25), "00:00:00:00");
  EXPECT_EQ(time_code_at(24, 25), "00:00:00:24");
  EXPECT_EQ(time_code_at(25, 25), "00:00:01:00");
  EXPECT_EQ(time_code_at(25 * 3661 + 7, 25), "01:01:01:07");
  EXPECT_EQ(time_code_at(24, 24000, 1001), "00:00:01:00");
  EXPECT_EQ(time_code_at(29, 30000, 1001), "00:00:00:29");
}

TEST(ExrAttributes, TimeCodeWrapsAtADayAndBeforeZero) {
  EXPECT_EQ(time_code_at(10 * 86400, 10), "00:00:00:00");
  EXPECT_EQ(time_code_at(-1, 25), "23:59:59:24");
  EXPECT_EQ(time_code_at(-1'000'000, 1), "10:13:20:00");
}

TEST(ExrAttributes, TimeCodeIsLeftOutWhereThereIsNone) {
  EXPECT_EQ(time_code_at(5, 60), "none");
  EXPECT_EQ(time_code_at(5, 31), "none");
  EXPECT_EQ(time_code_at(5, 30), "00:00:00:05");
  EXPECT_EQ(time_code_at(5, 1, 3), "none");
}

TEST(ExrAttributes, NumbersThatCannotBeStoredAreRefused) {
  FrameAttributes attributes;
  attributes.frame = std::int64_t{1} << 31;
  EXPECT_THROW(written_header(attributes), Error);
  attributes = {};
  attributes.fps_denominator = 0;
  EXPECT_THROW(written_header(attributes), Error);
  attributes = {};
  attributes.fps_numerator = std::int64_t{1} << 32;
  EXPECT_THROW(written_header(attributes), Error);
}

}  // namespace
}  // namespace morphcl
