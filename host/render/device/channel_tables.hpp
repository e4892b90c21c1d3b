// What kernels are told of channels beside colour and distance.
#pragma once

#include <vector>

#include "host/render/device/device_picture.hpp"
#include "host/render/device/mesh_store.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

// Empty in frames that have none of these channels; of the next frame only where velocity is asked for.
struct ChannelTables {
  layout::ChannelConstants constants{};    // without what depends on the pass, and where tables are
  std::vector<layout::ChannelDraw> draws;  // of each draw
  std::vector<layout::DrawConstants> next_draws;
  std::vector<layout::TargetConstants> next_targets;
  std::vector<layout::PreciseConstants> next_precise;
};

// Replaces `tables`, whose memory is used again. `draws`: those of the plan, as the kernels get them.
void make_channel_tables(const FramePlan& plan, const std::vector<layout::DrawConstants>& draws,
                         const MeshStore& meshes, const RawFrame& picture, ChannelTables& tables);

// Bytes of a tile's table of ids, and of the coverage behind it where some draw is blended.
constexpr std::size_t ids_bytes_of_tile(int samples, bool blends) {
  const std::size_t words = static_cast<std::size_t>(samples) + (blends ? 1 : 0);
  return sizeof(layout::TileIds) + std::size_t{layout::tile} * layout::tile * words * sizeof(layout::uint);
}

// Of tiles that leave tables of ids at one time: so many that the tables take 64 MB, and a row of tiles at least.
std::size_t max_tile_rows(const FramePlan& plan);

}  // namespace morphcl
