// Every channel that a frame can hold, to a file and back.
#include <ImfChannelList.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <set>

#include "host/image/channel_planes.hpp"
#include "host/image/exr_encode.hpp"
#include "host/image/exr_relabel.hpp"
#include "host/image/pixel_hash.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/channel_sets.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

constexpr std::array all_names{ChannelNames::plain, ChannelNames::blender, ChannelNames::nuke};
constexpr std::array lossless_methods{"none", "rle", "zips", "zip", "zip:small", "piz"};

std::string names_of(ChannelSet channels, ChannelNames names) {
  std::string text;
  for (const NamedPlane& plane : named_planes(channels, names)) text += plane.name + " ";
  return text;
}

// What docs/channels.md promises.
TEST(ChannelPlanes, Names) {
  EXPECT_EQ(names_of(every_channel - cryptomatte_channels, ChannelNames::plain),
            "A B G N.X N.Y N.Z P.X P.Y P.Z R Z albedo.B albedo.G albedo.R coverage material_id object_id uv.u uv.v "
            "velocity.u velocity.v ");
  EXPECT_EQ(names_of({Channel::crypto_object}, ChannelNames::plain),
            "crypto_object00.A crypto_object00.B crypto_object00.G crypto_object00.R "
            "crypto_object01.A crypto_object01.B crypto_object01.G crypto_object01.R "
            "crypto_object02.A crypto_object02.B crypto_object02.G crypto_object02.R ");
  EXPECT_EQ(names_of(every_channel - cryptomatte_channels, ChannelNames::nuke),
            "A B G N.X N.Y N.Z P.X P.Y P.Z R albedo.B albedo.G albedo.R depth.Z forward.u forward.v other.coverage "
            "other.material_id other.object_id uv.u uv.v ");
  EXPECT_EQ(names_of(every_channel - cryptomatte_channels, ChannelNames::blender),
            "ViewLayer.Combined.A ViewLayer.Combined.B ViewLayer.Combined.G ViewLayer.Combined.R ViewLayer.Coverage.X "
            "ViewLayer.Depth.Z ViewLayer.DiffCol.B ViewLayer.DiffCol.G ViewLayer.DiffCol.R ViewLayer.IndexMA.X "
            "ViewLayer.IndexOB.X ViewLayer.Normal.X ViewLayer.Normal.Y ViewLayer.Normal.Z ViewLayer.Position.X "
            "ViewLayer.Position.Y ViewLayer.Position.Z ViewLayer.UV.U ViewLayer.UV.V ViewLayer.Velocity.X "
            "ViewLayer.Velocity.Y ");
}

TEST(ChannelPlanes, EachNameOnceAndShortEnoughForEveryReader) {
  for (const ChannelNames names : all_names) {
    std::set<std::string> seen;
    for (const NamedPlane& plane : named_planes(every_channel, names)) {
      EXPECT_TRUE(seen.insert(plane.name).second) << plane.name;
      EXPECT_LE(plane.name.size(), 31u) << plane.name;
      EXPECT_TRUE(is_plane_name(plane.name));
    }
  }
  EXPECT_FALSE(is_plane_name("N"));
  EXPECT_FALSE(is_plane_name("r"));
}

// Each alone, each pair, and all together.
std::vector<ChannelSet> many_sets() {
  std::vector<ChannelSet> sets{every_channel};
  for (const Channel a : every_channel)
    for (const Channel b : every_channel)
      if (a <= b) sets.push_back({a, b});
  return sets;
}

TEST(ExrChannels, ComeBackBitForBitUnderAnyNames) {
  for (const ChannelSet channels : many_sets()) {
    const FrameBuffer frame = arbitrary_frame(37, 19, channels);
    const std::string hash = pixel_hash(frame);
    for (const ChannelNames names : all_names) {
      SCOPED_TRACE(morphcl::names_of(channels) + ", " + std::string(name_of(names)));
      std::vector<char> bytes;
      FrameAttributes attributes;
      attributes.channel_names = names;
      EXPECT_EQ(encode_exr(bytes, frame, attributes, "zip", 1), hash);
      const ExrFrame read = decode_exr(bytes);
      EXPECT_EQ(read.frame.channels(), channels);
      EXPECT_EQ(difference(frame, read.frame), "");
      EXPECT_EQ(read.hash, hash);
      EXPECT_EQ(read.stored_hash, hash);
    }
  }
}

TEST(ExrChannels, EveryLosslessCompressionKeepsEveryBit) {
  for (const bool noise : {false, true}) {
    const FrameBuffer frame = noise ? arbitrary_frame(130, 70, every_channel) : disc_frame(130, 70, every_channel);
    for (const char* compression : lossless_methods)
      for (const int threads : {1, 3}) {
        std::vector<char> bytes;
        const std::string hash = encode_exr(bytes, frame, {}, compression, threads);
        const ExrFrame read = decode_exr(bytes);
        EXPECT_EQ(difference(frame, read.frame), "") << compression;
        EXPECT_EQ(read.hash, hash) << compression;
      }
  }
}

// Numbers are kept by all compressions, also by those that are lossy.
TEST(ExrChannels, IdsSurviveLossyCompressions) {
  constexpr ChannelSet ids{Channel::object_id, Channel::material_id};
  const FrameBuffer frame = disc_frame(130, 70, ids);
  for (const std::string& compression : compression_names()) {
    std::vector<char> bytes;
    encode_exr(bytes, frame, {}, compression, 1);
    EXPECT_EQ(difference(frame, decode_exr(bytes).frame), "") << compression;
  }
}

TEST(ExrChannels, BlankBlocksAreBackgroundWhateverTheirMemoryHolds) {
  FrameBuffer marked = disc_frame(150, 140, every_channel), plain = disc_frame(150, 140, every_channel);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 10; ++x)
      if (y < 2 || y == 8 || (y % 2 == 0 && x % 3 != 0)) {
        make_blank(marked, x, y, 0x3c01);
        make_blank(plain, x, y, 0);
      }
  plain.data();  // nothing counts as blank any more
  EXPECT_EQ(pixel_hash(marked), pixel_hash(plain));
  std::vector<char> bytes, expected;
  encode_exr(bytes, marked, {}, "zip", 1);
  encode_exr(expected, plain, {}, "zip", 1);
  EXPECT_EQ(bytes, expected);
}

// The definition of the hash, by hand, of a frame with a channel of each type.
TEST(ExrChannels, PixelHashIsOverThePlanesByTheirPlainNames) {
  const FrameBuffer frame = arbitrary_frame(5, 3, {Channel::object_id, Channel::depth, Channel::normal});
  PixelHasher hasher;
  const auto add = [&](const char* name, Channel channel, int plane, PixelType type, std::size_t bytes) {
    hasher.begin_channel(name, type, {0, 0, 4, 2});
    for (int y = 0; y < 3; ++y) hasher.add_row(frame.plane_row(channel, plane, y).data(), 5 * bytes);
  };
  add("N.X", Channel::normal, 0, PixelType::half, 2);
  add("N.Y", Channel::normal, 1, PixelType::half, 2);
  add("N.Z", Channel::normal, 2, PixelType::half, 2);
  add("Z", Channel::depth, 0, PixelType::float_, 4);
  add("object_id", Channel::object_id, 0, PixelType::uint, 4);
  EXPECT_EQ(pixel_hash(frame), hasher.hex());
}

TEST(ExrChannels, TypesAreThoseOfTheirPlanes) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", disc_frame(8, 8, every_channel));
  const ExrDescription description = describe_exr(folder / "a.exr");
  EXPECT_EQ(description.channels.size(), named_planes(every_channel, ChannelNames::plain).size());
  const auto type_of = [&](const std::string& name) {
    for (const ExrChannel& channel : description.channels)
      if (channel.name == name) return channel.type;
    return std::string("none");
  };
  EXPECT_EQ(type_of("N.X"), "half");
  EXPECT_EQ(type_of("albedo.B"), "half");
  EXPECT_EQ(type_of("P.Y"), "float");
  EXPECT_EQ(type_of("velocity.u"), "float");
  EXPECT_EQ(type_of("uv.v"), "float");
  EXPECT_EQ(type_of("coverage"), "float");
  EXPECT_EQ(type_of("crypto_material02.A"), "float");
  EXPECT_EQ(type_of("object_id"), "uint");
  EXPECT_EQ(type_of("material_id"), "uint");
}

TEST(ExrChannels, LabelsOfAnotherFrameLeaveThePixelsAlone) {
  const FrameBuffer frame = disc_frame(90, 60, every_channel);
  FrameAttributes first, second;
  first.channel_names = second.channel_names = ChannelNames::blender;
  first.manifests = second.manifests = std::make_shared<CryptomatteManifests>("{}", R"({"bunny":"13851a76"})");
  second.frame = 123456;
  for (const char* compression : {"zip", "piz"}) {
    std::vector<char> source, direct, relabelled;
    encode_exr(source, frame, first, compression, 1);
    const std::string hash = encode_exr(direct, frame, second, compression, 1);
    EXPECT_EQ(relabel_exr(relabelled, source, second), hash);
    EXPECT_EQ(relabelled, direct) << compression;
  }
}

TEST(ExrChannels, FinishedFramesAreKnownByThem) {
  const TemporaryFolder folder;
  FrameAttributes attributes;
  attributes.fingerprint = "of the shot";
  attributes.channel_names = ChannelNames::nuke;
  const std::string hash = write_exr(folder / "a.exr", disc_frame(90, 60, every_channel), attributes);
  EXPECT_TRUE(is_finished_frame(folder / "a.exr", "of the shot"));
  EXPECT_NO_THROW(verify_exr(folder / "a.exr", hash));
}

}  // namespace
}  // namespace morphcl
