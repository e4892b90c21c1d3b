// Which of the vertices that are on the device from the frame drawn before are those of this frame too.
#pragma once

#include <utility>

#include "host/render/device/frame_tables.hpp"

namespace morphcl {

class KeptVertices {
 public:
  // Chunks (of layout::groups_per_chunk vertex groups) in which some draw's vertices have to be projected again: its
  // matrices, targets, attributes, place among the records or the picture's grid are not what they were.
  std::vector<layout::uint> changed_chunks(const FrameTables& tables) const;
  // Whether some face's light may differ.
  bool faces_changed(const FrameTables& tables) const;

  // Takes the tables of the frame that was drawn and leaves older ones, whose memory can be used again.
  void remember(FrameTables& tables) {
    std::swap(drawn_, tables);
    known_ = true;
  }
  void forget() { known_ = false; }
  // Also of the draws, whose meshes are stored elsewhere now.
  void forget_meshes() {
    known_ = false;
    drawn_.origin = {};
  }

 private:
  bool same_view(const FrameTables& tables) const;
  bool same_draw(const FrameTables& tables, std::size_t draw) const;

  FrameTables drawn_;
  bool known_ = false;
};

}  // namespace morphcl
