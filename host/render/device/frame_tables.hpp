// The tables that the kernels walk through for one plan: draws, active targets, lights, and which draw each vertex
// group and primitive group belongs to.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "host/render/device/channel_tables.hpp"
#include "host/render/device/device_picture.hpp"
#include "host/render/device/mesh_store.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

// Which draws a table holds; none is known for `version` 0.
struct DrawsOrigin {
  std::uint64_t planner = 0, version = 0;
  bool operator==(const DrawsOrigin&) const = default;
};

struct FrameTables {
  DrawsOrigin origin;
  std::vector<layout::DrawConstants> draws;
  std::vector<layout::TargetConstants> targets;
  std::vector<layout::PreciseConstants> precise;  // of draws that are not plain
  std::vector<layout::LightConstants> lights;
  std::shared_ptr<const std::vector<BackgroundRow>> background;  // null: none
  using PositionsHash = std::array<std::uint64_t, 2>;
  std::vector<PositionsHash> displaced;  // of each draw; 0 where the positions are its mesh's
  layout::FrameConstants frame{};        // without what depends on pools, chunks and where tables are
  ChannelTables channels;
  bool any_flat = false, any_smooth = false, any_colors = false;
  bool any_attributes = false;  // of vertices, for light or channel N
  bool only_faces = true;       // every draw is flat, lit at its centre, and without vertex colours
};

// Replaces `tables`, whose memory is used again, and their draws too where they come from the same: the meshes must
// still be stored where they were, or `origin` be cleared. Error(bad_input) when the frame has more vertices or
// primitives than ids can number.
void make_frame_tables(const FramePlan& plan, const MeshStore& meshes, const DevicePicture& picture,
                       FrameTables& tables);

// For each vertex group and each primitive group of the draws, which follow each other, the draw it belongs to.
std::vector<layout::uint> draw_of_vertex_groups(const std::vector<layout::DrawConstants>& draws);
std::vector<layout::uint> draw_of_primitive_groups(const std::vector<layout::DrawConstants>& draws);
// For each place in the order of binning the draw whose primitive group is binned there.
std::vector<layout::uint> draw_in_order(const std::vector<layout::DrawConstants>& draws);

}  // namespace morphcl
