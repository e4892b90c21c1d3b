#include "host/image/raw_frame.hpp"
#include "morphcl/frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "morphcl/error.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl {
namespace {

TEST(FrameBuffer, RowsOfAllChannelsFollowEachOtherInWholeTiles) {
  const FrameBuffer frame(65, 64, {Channel::color, Channel::depth});
  EXPECT_EQ(frame.width(), 65);
  EXPECT_EQ(frame.height(), 64);
  for (int channel = 0; channel < 4; ++channel)
    EXPECT_EQ(frame.plane_offset(Channel::color, channel), 128u * 2 * static_cast<unsigned>(channel));
  EXPECT_EQ(frame.plane_offset(Channel::depth, 0), 128u * 8);
  constexpr std::size_t notes = 64;  // a cache line holds those of 16 tiles
  EXPECT_EQ(frame.row_bytes(), 128u * 12 + notes);
  EXPECT_EQ(frame.bytes(), (128u * 12 + notes) * 64);
  EXPECT_EQ(FrameBuffer(1, 1, {Channel::color}).bytes(), (64u * 8 + notes) * 64);
  EXPECT_EQ(FrameBuffer(1, 65, {Channel::depth}).bytes(), (64u * 4 + notes) * 128);
  EXPECT_EQ(FrameBuffer(17 * 64, 1, {Channel::depth}).row_bytes(), 17u * 64 * 4 + 2 * notes);
  EXPECT_EQ(FrameBuffer(1, 1, {Channel::depth}).plane_offset(Channel::depth, 0), 0u);
}

TEST(FrameBuffer, SpansAreTheRowsWhereThePitchSays) {
  FrameBuffer frame(70, 130, {Channel::color, Channel::depth});
  const FrameBuffer& same = frame;
  for (const int y : {0, 1, 64, 129}) {
    const std::byte* const row = same.data() + static_cast<std::size_t>(y) * same.row_bytes();
    for (int channel = 0; channel < 4; ++channel) {
      EXPECT_EQ(same.color_row(channel, y).size(), 70u);
      EXPECT_EQ(reinterpret_cast<const std::byte*>(same.color_row(channel, y).data()),
                row + same.plane_offset(Channel::color, channel));
      EXPECT_EQ(frame.color_row(channel, y).data(), same.color_row(channel, y).data());
    }
    EXPECT_EQ(same.depth_row(y).size(), 70u);
    EXPECT_EQ(reinterpret_cast<const std::byte*>(same.depth_row(y).data()), row + same.plane_offset(Channel::depth, 0));
    EXPECT_EQ(frame.depth_row(y).data(), same.depth_row(y).data());
  }
}

TEST(FrameBuffer, OnlyWantedChannelsExist) {
  const FrameBuffer color(8, 8, {Channel::color}), depth(8, 8, {Channel::depth}), none(8, 8, {});
  EXPECT_TRUE(color.has_color() && !color.has_depth() && color.depth_row(0).empty());
  EXPECT_TRUE(!depth.has_color() && depth.has_depth() && depth.color_row(3, 0).empty());
  EXPECT_TRUE(!none.has_color() && !none.has_depth() && none.color_row(0, 0).empty() && none.depth_row(0).empty());
}

// OpenCL uses the memory in place, also that of a band alone: some whole rows of tiles.
TEST(FrameBuffer, FramesAndTheirRowsOfTilesStartOnPages) {
  const FrameBuffer small(64, 64, {Channel::color, Channel::depth}),
      large(1920, 1080, {Channel::color, Channel::depth});
  constexpr std::uintptr_t page = 4096, huge_page = 2 << 20;
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(small.data()) % page, 0u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.data()) % huge_page, 0u);
  for (const int width : {1, 65, 1920, 2048, 16384, 32768})
    for (const ChannelSet channels : choices_of_two) {
      const FrameBuffer frame(width, 65, channels);
      EXPECT_EQ(frame.row_bytes() * FrameBuffer::tile_side % page, 0u) << width;
      EXPECT_EQ(frame.row_bytes() % 64, 0u) << width;
      EXPECT_EQ(frame.plane_offset(Channel::depth, 0) % 64, 0u) << width;
    }
}

TEST(FrameBuffer, FreshMemoryIsZeroAlsoAfterOthersUsedIt) {
  for (int round = 0; round < 3; ++round) {
    FrameBuffer frame(1500, 900, {Channel::color, Channel::depth});
    std::byte* const memory = frame.data();
    ASSERT_TRUE(std::all_of(memory, memory + frame.bytes(), [](std::byte v) { return v == std::byte{0}; }));
    std::fill_n(memory, frame.bytes(), std::byte{0xff});
  }
}

TEST(FrameBuffer, LargeFrameTakesMemoryOnlyWhereItIsWritten) {
  FrameBuffer frame(16384, 16384, {Channel::color, Channel::depth});  // 3 GiB of addresses
  frame.color_row(3, 16383).back() = 7;
  frame.depth_row(16383).back() = 7;
  EXPECT_EQ(frame.color_row(0, 16383).back(), 0);
}

TEST(FrameBuffer, MovedFrameKeepsItsMemory) {
  FrameBuffer frame(70, 70, {Channel::color, Channel::depth});
  std::uint16_t* const row = frame.color_row(0, 0).data();
  row[5] = 1234;
  FrameBuffer moved = std::move(frame);
  EXPECT_EQ(moved.color_row(0, 0).data(), row);
  EXPECT_EQ(moved.color_row(0, 0)[5], 1234);
}

TEST(FrameBuffer, ImpossibleSizesAreRefused) {
  for (const auto& [width, height] : {std::pair{0, 4},
                                      {4, 0},
                                      {-1, 4},
                                      {4, -1},
                                      {FrameBuffer::max_side + 1, 1},
                                      {1, FrameBuffer::max_side + 1},
                                      {2147483647, 2147483647}})
    try {
      FrameBuffer frame(width, height, {Channel::color, Channel::depth});
      ADD_FAILURE() << width << " x " << height << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    }
}

TEST(FrameBuffer, NotesOfBlankTilesAreGoneOnceOthersMayHaveWritten) {
  FrameBuffer frame(64, 64, {Channel::color, Channel::depth});
  RawFrame(frame).note(0, 0) = 0xffff;
  EXPECT_TRUE(frame.blank(0, 0));
  EXPECT_TRUE(RawFrame(frame).notes_hold);
  frame.color_row(0, 0)[0] = 1;
  EXPECT_FALSE(frame.blank(0, 0));
  EXPECT_FALSE(RawFrame(frame).notes_hold);  // and a renderer that now fails has drawn nothing blank:
  EXPECT_FALSE(frame.blank(0, 0));
}

}  // namespace
}  // namespace morphcl
