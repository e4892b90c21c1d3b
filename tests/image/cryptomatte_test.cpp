// Cryptomatte's ids, manifests and headers.
#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "host/cryptomatte_id.hpp"
#include "host/cryptomatte_manifest.hpp"
#include "host/murmur3.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

// Vectors that go round with the function: of its test suites in C#, Guava and Wikipedia.
TEST(Murmur3, PublishedValues) {
  const auto text = [](std::initializer_list<int> bytes) { return std::string(bytes.begin(), bytes.end()); };
  EXPECT_EQ(murmur3_32("", 0), 0u);
  EXPECT_EQ(murmur3_32("", 1), 0x514e28b7u);
  EXPECT_EQ(murmur3_32("", 0xffffffff), 0x81f16f39u);
  EXPECT_EQ(murmur3_32(text({0xff, 0xff, 0xff, 0xff}), 0), 0x76293b50u);
  EXPECT_EQ(murmur3_32(text({0x21, 0x43, 0x65, 0x87}), 0), 0xf55b516bu);
  EXPECT_EQ(murmur3_32(text({0x21, 0x43, 0x65, 0x87}), 0x5082edee), 0x2362f9deu);
  EXPECT_EQ(murmur3_32(text({0x21, 0x43, 0x65}), 0), 0x7e4a8634u);
  EXPECT_EQ(murmur3_32(text({0x21, 0x43}), 0), 0xa0f7b07au);
  EXPECT_EQ(murmur3_32(text({0x21}), 0), 0x72661cf4u);
  EXPECT_EQ(murmur3_32(text({0, 0, 0, 0}), 0), 0x2362f9deu);
  EXPECT_EQ(murmur3_32(text({0}), 0), 0x514e28b7u);
  EXPECT_EQ(murmur3_32("The quick brown fox jumps over the lazy dog", 0), 0x2e4ff723u);
  EXPECT_EQ(murmur3_32("Hello, world!", 0x9747b28c), 0x24884cbau);
}

// The examples of the specification's metadata.
TEST(CryptomatteId, NamesOfTheSpecification) {
  EXPECT_EQ(cryptomatte_bits("bunny"), 0x13851a76u);
  EXPECT_EQ(cryptomatte_bits("default"), 0x42c9679fu);
  EXPECT_EQ(cryptomatte_id("bunny"), 3.36000126250930e-27f);
}

// Among many names some have the exponents that are mended; everything else stays.
TEST(CryptomatteId, NoIdIsZeroDenormalInfiniteOrNaN) {
  int mended_low = 0, mended_high = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string name = "object" + std::to_string(i);
    const std::uint32_t hash = murmur3_32(name), bits = cryptomatte_bits(name), exponent = hash >> 23 & 255;
    ASSERT_TRUE(std::isnormal(cryptomatte_id(name))) << name;
    ASSERT_EQ(bits & 0x807fffffu, hash & 0x807fffffu) << name;
    ASSERT_EQ(bits >> 23 & 255, exponent == 0 ? 1 : exponent == 255 ? 254 : exponent) << name;
    mended_low += exponent == 0;
    mended_high += exponent == 255;
  }
  EXPECT_GT(mended_low, 0);
  EXPECT_GT(mended_high, 0);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(cryptomatte_id("")), 0x00800000u);  // the hash is 0
}

TEST(CryptomatteManifest, NamesEachOnceAndEscaped) {
  EXPECT_EQ(cryptomatte_manifest({}), "{}");
  const std::vector<std::string> twice = {"bunny", "default", "bunny"};
  EXPECT_EQ(cryptomatte_manifest(twice), R"({"bunny":"13851a76","default":"42c9679f"})");
  const auto key_of = [](const std::string& name) {
    const std::string json = cryptomatte_manifest(std::vector{name});
    return json.substr(1, json.find("\":\"") - 0);
  };
  EXPECT_EQ(key_of("a\"b\\c"), R"("a\"b\\c")");
  EXPECT_EQ(key_of("line\nend\x01"), R"("line\u000aend\u0001")");
  EXPECT_EQ(key_of("Würfel ▲ 😀"), "\"Würfel ▲ 😀\"");
  EXPECT_EQ(key_of("W\xfcrfel"), "\"W\\ufffdrfel\"");              // Latin-1
  EXPECT_EQ(key_of("\xc0\x80"), "\"\\ufffd\\ufffd\"");             // overlong
  EXPECT_EQ(key_of("\xed\xa0\x80"), "\"\\ufffd\\ufffd\\ufffd\"");  // a surrogate
  EXPECT_EQ(key_of("\xe2\x96"), "\"\\ufffd\\ufffd\"");             // cut off
}

std::string text_of(const Imf::Header& header, const char* name) {
  const auto* text = header.findTypedAttribute<Imf::StringAttribute>(name);
  return text ? text->value() : "none";
}

Imf::Header header_of_file(ChannelSet channels, const FrameAttributes& attributes) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", disc_frame(20, 20, channels), attributes);
  return Imf::InputFile((folder / "a.exr").c_str()).header();
}

TEST(CryptomatteHeader, DescribesEachLayerThatIsThere) {
  FrameAttributes attributes;
  attributes.manifests = std::make_shared<CryptomatteManifests>(R"({"bunny":"13851a76"})", R"({"default":"42c9679f"})");
  const Imf::Header header = header_of_file(default_channels | ChannelSet{Channel::crypto_object}, attributes);
  EXPECT_EQ(text_of(header, "cryptomatte/f834d0a/name"), "crypto_object");
  EXPECT_EQ(text_of(header, "cryptomatte/f834d0a/hash"), "MurmurHash3_32");
  EXPECT_EQ(text_of(header, "cryptomatte/f834d0a/conversion"), "uint32_to_float32");
  EXPECT_EQ(text_of(header, "cryptomatte/f834d0a/manifest"), R"({"bunny":"13851a76"})");
  int texts = 0;
  for (auto i = header.begin(); i != header.end(); ++i) texts += std::string(i.name()).starts_with("cryptomatte/");
  EXPECT_EQ(texts, 4);
  EXPECT_EQ(text_of(header_of_file(default_channels, attributes), "cryptomatte/f834d0a/name"), "none");
  EXPECT_EQ(text_of(header_of_file({Channel::crypto_object}, {}), "cryptomatte/f834d0a/manifest"), "none");
}

// Readers look for channels that begin with the layer's name, and for the key by its hash.
TEST(CryptomatteHeader, NamesTheLayerAsItsChannelsAre) {
  FrameAttributes attributes;
  attributes.channel_names = ChannelNames::blender;
  const Imf::Header header = header_of_file({Channel::crypto_material}, attributes);
  const std::string key = fmt::format("cryptomatte/{:08x}", murmur3_32("ViewLayer.CryptoMaterial")).substr(0, 19);
  EXPECT_EQ(text_of(header, (key + "/name").c_str()), "ViewLayer.CryptoMaterial");
  EXPECT_NE(header.channels().findChannel("ViewLayer.CryptoMaterial02.A"), nullptr);
}

TEST(CryptomatteHeader, LossyCompressionsAreRefused) {
  const TemporaryFolder folder;
  for (const char* compression : {"pxr24", "b44", "b44a", "dwaa", "dwab"}) {
    try {
      write_exr(folder / "a.exr", disc_frame(8, 8, {Channel::color, Channel::crypto_object}), {}, compression);
      ADD_FAILURE() << compression;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_EQ(error.message(), fmt::format("the compression {} is lossy, and crypto_object holds ids, which it would "
                                             "change; none, rle, zips, zip, zip:small and piz keep every bit",
                                             compression));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
    EXPECT_NO_THROW(check_compression(compression, every_channel - cryptomatte_channels));
  }
}

}  // namespace
}  // namespace morphcl
