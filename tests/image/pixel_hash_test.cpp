#include "host/image/pixel_hash.hpp"
#include "host/image/raw_frame.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <set>
#include <vector>

#include "tests/image/test_frames.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl {
namespace {

using image_test::arbitrary_frame;
using image_test::disc_frame;
using image_test::make_blank;

// The definition in the header, written out as one block of bytes.
class HashedBytes {
 public:
  void text(const char* name) { add(name, std::char_traits<char>::length(name) + 1); }
  void integers(std::initializer_list<std::int32_t> list) {
    for (const std::int32_t value : list) add(&value, sizeof value);
  }
  void add(const void* values, std::size_t count) {
    const char* first = static_cast<const char*>(values);
    bytes_.insert(bytes_.end(), first, first + count);
  }
  std::string hash() const {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes_.data(), bytes_.size()));
    std::string hex;
    for (const unsigned char digit : canonical.digest) hex += fmt::format("{:02x}", digit);
    return hex;
  }

 private:
  std::vector<char> bytes_;
};

TEST(PixelHash, IsTheDocumentedFunction) {
  const FrameBuffer frame = arbitrary_frame(67, 5, {Channel::color, Channel::depth});
  HashedBytes bytes;
  const std::pair<const char*, int> channels[] = {{"A", 3}, {"B", 2}, {"G", 1}, {"R", 0}};
  for (const auto& [name, channel] : channels) {
    bytes.text(name);
    bytes.integers({1, 0, 0, 66, 4});
    for (int y = 0; y < 5; ++y) bytes.add(frame.color_row(channel, y).data(), 67 * 2);
  }
  bytes.text("Z");
  bytes.integers({2, 0, 0, 66, 4});
  for (int y = 0; y < 5; ++y) bytes.add(frame.depth_row(y).data(), 67 * 4);
  EXPECT_EQ(pixel_hash(frame), bytes.hash());
  EXPECT_EQ(pixel_hash(frame).size(), 32u);
}

TEST(PixelHash, EveryFlippedBitOfEveryChannelChangesIt) {
  FrameBuffer frame = disc_frame(9, 7);
  std::set<std::string> hashes{pixel_hash(frame)};
  for (int bit = 0; bit < 16; ++bit)
    for (int channel = 0; channel < 4; ++channel) {
      std::uint16_t& value = frame.color_row(channel, 3)[4];
      value = static_cast<std::uint16_t>(value ^ (1u << bit));
      EXPECT_TRUE(hashes.insert(pixel_hash(frame)).second) << "bit " << bit << " of channel " << channel;
      value = static_cast<std::uint16_t>(value ^ (1u << bit));
    }
  for (int bit = 0; bit < 32; ++bit) {
    float& value = frame.depth_row(6)[8];
    const float before = value;
    value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ (1u << bit));
    EXPECT_TRUE(hashes.insert(pixel_hash(frame)).second) << "bit " << bit << " of Z";
    value = before;
  }
}

TEST(PixelHash, TellsNansByTheirPayloadAndZerosByTheirSign) {
  FrameBuffer frame = disc_frame(4, 4);
  std::set<std::string> hashes;
  for (const std::uint32_t bits : {0x7fc00000u, 0x7fc00001u, 0xffc00000u, 0x00000000u, 0x80000000u}) {
    frame.depth_row(0)[0] = std::bit_cast<float>(bits);
    EXPECT_TRUE(hashes.insert(pixel_hash(frame)).second) << std::hex << bits;
  }
}

TEST(PixelHash, LeavesThePaddingOut) {
  FrameBuffer frame = disc_frame(9, 7);
  const std::string before = pixel_hash(frame);
  const std::size_t row = frame.row_bytes();
  for (int channel = 0; channel < 4; ++channel) frame.color_row(channel, 0).data()[9] = 77;  // right of the picture
  frame.depth_row(6).data()[9] = 77;
  std::fill_n(frame.data() + 7 * row, frame.bytes() - 7 * row, std::byte{77});  // below it
  EXPECT_EQ(pixel_hash(frame), before);
}

// Background that is known to be there is not read, and has the same hash.
TEST(PixelHash, BlankBlocksCountAsTheBackgroundThatTheyAre) {
  FrameBuffer plain(150, 70, {Channel::color, Channel::depth}), marked(150, 70, {Channel::color, Channel::depth});
  for (int y = 0; y < 70; ++y) {
    std::ranges::fill(plain.depth_row(y), background_depth);
    std::ranges::fill(marked.depth_row(y), 1.0f);  // is not looked at
  }
  for (FrameBuffer* const frame : {&plain, &marked}) {
    for (int y = 0; y < 16; ++y) std::ranges::fill(frame->depth_row(y).first(16), background_depth);
    for (int y = 64; y < 70; ++y) std::ranges::fill(frame->depth_row(y).last(6), background_depth);
    frame->color_row(2, 0)[5] = frame->color_row(2, 69)[149] = 0x3c00;
  }
  const RawFrame memory(marked);  // the last to touch it, so that its notes hold
  for (int tile = 0; tile < 6; ++tile) memory.note(tile % 3, tile / 3) = 0xffff;
  memory.note(0, 0) = 0xfffe;  // all but the first block
  memory.note(2, 1) = 0xfffd;  // all but the one with the last pixel
  EXPECT_EQ(pixel_hash(marked), pixel_hash(plain));
}

TEST(PixelHash, TellsChannelsAndWindowsOfTheSameValues) {
  std::set<std::string> hashes;
  for (const auto& [width, height] : {std::pair{4, 6}, {6, 4}, {24, 1}, {1, 24}, {12, 2}})
    for (const ChannelSet channels : choices_of_two)
      EXPECT_TRUE(hashes.insert(pixel_hash(FrameBuffer(width, height, channels))).second);
}

TEST(TextHash, IsTheFunctionOfItsBytes) {
  EXPECT_EQ(text_hash(""), "99aa06d3014798d86001c324468d497f");  // published for the empty input
  EXPECT_NE(text_hash("a"), text_hash("b"));
}

// Blank pixels are hashed without a look at their memory, many at a time: more than there are in a line, and more than
// are taken at once.
TEST(PixelHash, BlankBlocksAreBackgroundWhateverTheirMemoryHolds) {
  for (const ChannelSet channels : choices_of_two) {
    FrameBuffer marked = disc_frame(2600, 60, channels), plain = disc_frame(2600, 60, channels);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 163; ++x)
        if (y != 2 || x % 5 < 3) {
          make_blank(marked, x, y, 0x3c01);
          make_blank(plain, x, y, 0);
        }
    plain.data();  // nothing counts as blank any more
    ASSERT_TRUE(marked.blank_block(162, 3));
    ASSERT_FALSE(plain.blank_block(162, 3));
    EXPECT_EQ(pixel_hash(marked), pixel_hash(plain)) << names_of(channels);
  }
}

}  // namespace
}  // namespace morphcl
