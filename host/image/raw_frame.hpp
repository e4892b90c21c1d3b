// A frame's memory as renderers take it: the pixels, and notes about which of them are background.
//
// The notes of a row of tiles stand one after the other in the first row of their pixels, behind the channels. Bit b of
// a note is set when the tile's block b of 16 x 16 pixels (four a row) is blank. The renderer keeps them true to what
// it writes.
#pragma once

#include "morphcl/frame.hpp"

namespace morphcl {

struct RawFrame {
  // Notes that are void are set to 0. A frame of 2 MB and more lies on huge pages, where the system has them.
  explicit RawFrame(FrameBuffer& frame);

  std::uint32_t& note(int tile_x, int tile_y) const {
    std::byte* const row = data + static_cast<std::size_t>(tile_y) * FrameBuffer::tile_side * row_bytes;
    return reinterpret_cast<std::uint32_t*>(row + notes_offset)[tile_x];
  }

  std::size_t plane_offset(Channel channel, int plane) const {
    return offsets[static_cast<std::size_t>(channel)] +
           static_cast<std::size_t>(plane) * padded_width * bytes_of(plane_type(channel));
  }

  std::byte* data;        // this and what follows as FrameBuffer has it
  std::size_t row_bytes;  // FrameBuffer::tile_side times this is a multiple of a page
  std::size_t bytes;
  std::size_t notes_offset;
  ChannelSet channels;
  std::size_t padded_width;                        // pixels: a row of a plane
  std::array<std::size_t, channel_count> offsets;  // of each channel's first plane; 0 of one that the frame lacks
  bool notes_hold;  // false: the notes are void, others may have written to the frame since they were made
};

}  // namespace morphcl
