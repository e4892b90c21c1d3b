// Which of the vertices and faces that are on the device from the frame drawn before are those of this frame too.
#pragma once

#include <vector>

#include "host/render/device/frame_tables.hpp"

namespace morphcl {

// `before`: the tables that vertices and faces on the device were made from; null when none is known.

// Chunks (of layout::vertex_groups_per_chunk vertex groups) in which some draw's vertices have to be projected again:
// its matrices, targets, attributes, place among the records or the picture's grid are not what they were.
std::vector<layout::uint> changed_vertex_chunks(const FrameTables& now, const FrameTables* before);

// Whether some face's light may differ.
bool faces_changed(const FrameTables& now, const FrameTables* before);

}  // namespace morphcl
