#include "host/image/frame_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/error.hpp"

namespace morphcl {
namespace {

TEST(FrameBuffer, RowsAndPlanesAreWholeTiles) {
  const FrameBuffer frame(65, 64, true, true);
  EXPECT_EQ(frame.width(), 65);
  EXPECT_EQ(frame.height(), 64);
  EXPECT_EQ(frame.row_pitch(), 128u);
  EXPECT_EQ(frame.plane_elements(), 128u * 64u);
  EXPECT_EQ(FrameBuffer(1, 1, true, false).plane_elements(), 64u * 64u);
}

TEST(FrameBuffer, OnlyWantedPlanesExist) {
  const FrameBuffer color(8, 8, true, false), depth(8, 8, false, true), none(8, 8, false, false);
  EXPECT_TRUE(color.has_color() && !color.has_depth() && color.depth() == nullptr);
  EXPECT_TRUE(!depth.has_color() && depth.has_depth() && depth.color(3) == nullptr);
  EXPECT_TRUE(!none.has_color() && !none.has_depth());
}

TEST(FrameBuffer, PlanesStartOnPages) {
  const FrameBuffer small(64, 64, true, true), large(1920, 1080, true, true);
  constexpr std::uintptr_t page = 4096, huge_page = 2 << 20;
  for (int channel = 0; channel < 4; ++channel) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(small.color(channel)) % page, 0u) << channel;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.color(channel)) % huge_page, 0u) << channel;
  }
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.depth()) % huge_page, 0u);
}

TEST(FrameBuffer, FreshMemoryIsZeroAlsoAfterOthersUsedIt) {
  for (int round = 0; round < 3; ++round) {
    FrameBuffer frame(1500, 900, true, true);
    for (int channel = 0; channel < 4; ++channel) {
      std::uint16_t* plane = frame.color(channel);
      ASSERT_TRUE(std::all_of(plane, plane + frame.plane_elements(), [](std::uint16_t v) { return v == 0; }));
      std::fill_n(plane, frame.plane_elements(), std::uint16_t{0xffff});
    }
    ASSERT_TRUE(std::all_of(frame.depth(), frame.depth() + frame.plane_elements(), [](float v) { return v == 0; }));
    std::fill_n(frame.depth(), frame.plane_elements(), 1.0f);
  }
}

TEST(FrameBuffer, LargeFrameTakesMemoryOnlyWhereItIsWritten) {
  FrameBuffer frame(16384, 16384, true, true);  // 3 GiB of addresses
  frame.color(3)[frame.plane_elements() - 1] = 7;
  frame.depth()[frame.plane_elements() - 1] = 7;
  EXPECT_EQ(frame.color(0)[frame.plane_elements() - 1], 0);
}

TEST(FrameBuffer, MovedFrameKeepsItsPlanes) {
  FrameBuffer frame(70, 70, true, true);
  std::uint16_t* plane = frame.color(0);
  plane[5] = 1234;
  FrameBuffer moved = std::move(frame);
  EXPECT_EQ(moved.color(0), plane);
  EXPECT_EQ(moved.color(0)[5], 1234);
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
      FrameBuffer frame(width, height, true, true);
      ADD_FAILURE() << width << " x " << height << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    }
}

TEST(FrameBuffer, NotesOfBlankTilesAreGoneOnceOthersMayHaveWritten) {
  FrameBuffer frame(64, 64, true, true);
  frame.planes().blank_blocks[0] = 0xffff;
  EXPECT_TRUE(frame.blank(0, 0));
  EXPECT_TRUE(frame.planes().notes_hold);
  frame.color(0)[0] = 1;
  EXPECT_FALSE(frame.blank(0, 0));
  EXPECT_FALSE(frame.planes().notes_hold);  // and a renderer that now fails has drawn nothing blank:
  EXPECT_FALSE(frame.blank(0, 0));
}

}  // namespace
}  // namespace morphcl
