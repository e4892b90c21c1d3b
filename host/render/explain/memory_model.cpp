#include "host/render/explain/memory_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "host/render/frame/bin_pools.hpp"
#include "host/render/frame/channel_passes.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

namespace {

std::size_t padded(std::size_t count, std::size_t multiple) { return (count + multiple - 1) / multiple * multiple; }

// Planes of floats, every attribute of the mesh and its targets, whether a frame uses it or not.
std::size_t attribute_bytes(const Mesh& mesh, bool with_uvs) {
  std::size_t planes =
      3 + (mesh.normals.empty() ? 0 : 3) + (mesh.colors.empty() ? 0 : 4) + (!with_uvs || mesh.uvs.empty() ? 0 : 2);
  for (const MorphTarget& target : mesh.targets)
    planes += (target.positions.empty() ? 0 : 3) + (target.normals.empty() || mesh.normals.empty() ? 0 : 3) +
              (target.colors.empty() || mesh.colors.empty() ? 0 : 4);
  return planes * padded(mesh.positions.size(), layout::lanes) * sizeof(float);
}

std::size_t primitive_count(const Draw& draw) {
  if (draw.shading != Shading::wireframe) return draw.mesh->triangles.size();
  return draw.mesh->edges.empty() ? draw.mesh->triangles.size() * 3 / 2 : draw.mesh->edges.size();
}

struct Totals {
  std::size_t attributes = 0, indices = 0;  // bytes, each mesh once
  std::size_t vertices = 0, primitives = 0;
  bool has_attributes = false, flat = false, tinted = false;
};

Totals add_up(const FramePlan& plan) {
  Totals totals;
  std::set<const Mesh*> meshes;
  for (const Draw& draw : plan.draws) {
    const std::size_t primitives = padded(primitive_count(draw), layout::lanes);
    if (draw.displaced) totals.attributes += 3 * padded(draw.mesh->positions.size(), layout::lanes) * sizeof(float);
    totals.vertices += padded(draw.mesh->positions.size(), layout::lanes);
    totals.primitives += primitives;
    totals.flat |= draw.shading == Shading::flat;
    totals.has_attributes |=
        draw.shading == Shading::flat || draw.shading == Shading::smooth || draw.normals != NormalSource::none;
    totals.tinted |= draw.vertex_colors;
    if (!meshes.insert(draw.mesh).second) continue;
    totals.attributes += attribute_bytes(*draw.mesh, plan.has(Channel::uv));
    totals.indices +=
        3 * sizeof(layout::uint) *
        (padded(draw.mesh->triangles.size(), layout::lanes) + (draw.shading == Shading::wireframe ? primitives : 0));
  }
  return totals;
}

}  // namespace

MemoryNeed estimate_memory(const FramePlan& plan) {
  const Totals totals = add_up(plan);
  MemoryNeed need;
  const auto add = [&need](std::size_t& sum, std::size_t bytes, const char* name) {
    sum += bytes;
    if (bytes > need.largest_buffer) {
      need.largest_buffer = bytes;
      need.largest_name = name;
    }
  };
  add(need.meshes, totals.attributes, "vertices and morph targets of the meshes");
  add(need.meshes, totals.indices, "indices of the meshes");
  constexpr std::size_t record = 16;
  add(need.vertices, totals.vertices * record, "projected vertices");
  if (totals.has_attributes) add(need.vertices, totals.vertices * record, "normals");
  if (totals.tinted) add(need.vertices, totals.vertices * record, "vertex colours");
  if (totals.flat) add(need.vertices, totals.primitives * record, "light of the faces");
  if (plan.has(Channel::velocity)) {
    add(need.vertices, totals.vertices * 2 * record, "vertices of this frame and the next");
    for (const Draw& draw : plan.next_draws)
      if (draw.displaced) need.meshes += 3 * padded(draw.mesh->positions.size(), layout::lanes) * sizeof(float);
  }

  // Its bins as the device renderer lays them out before the first frame.
  layout::FrameConstants constants{};
  constants.tiles_x = static_cast<int>(padded(static_cast<std::size_t>(plan.width), layout::tile) / layout::tile);
  constants.tiles_y = static_cast<int>(padded(static_cast<std::size_t>(plan.height), layout::tile) / layout::tile);
  constants.vertex_group_count = static_cast<layout::uint>(totals.vertices / layout::lanes);
  constants.primitive_group_count = static_cast<layout::uint>(totals.primitives / layout::lanes);
  constants.clips = plan.clips;
  constants.blends = plan.blends;
  BinPools pools = pools_of(plan.samples);
  const BinSizes sizes = lay_out_bins(std::numeric_limits<std::size_t>::max(), pools, constants);
  if (plan.samples > 1) add(need.bins, sizes.sample_fragments, "samples of small triangles");
  if (plan.samples == 1 || draws_centres(plan)) add(need.bins, sizes.fragment_keys, "fragments of small triangles");
  add(need.bins, sizes.large, "large triangles");
  // Of tables of ids there is a band of 64 MB at most.
  const std::size_t of_pixels =
      (plan.channels & channels_of_samples).empty() ? 1 : static_cast<std::size_t>(plan.samples);
  if (!(plan.channels & (channels_of_centres | channels_of_samples)).empty())
    need.bins +=
        std::min(static_cast<std::size_t>(constants.tiles_x) * static_cast<std::size_t>(constants.tiles_y) *
                     (sizeof(layout::TileIds) + layout::tile * layout::tile * sizeof(layout::uint) * of_pixels),
                 std::size_t{64} << 20);
  // Neither these nor the picture is a buffer that may be too large: where they do not fit, a device gets the lists of
  // fewer chunks, and the picture in as many pieces as it wants.
  need.bins += sizes.bins;
  const std::size_t samples = static_cast<std::size_t>(constants.tiles_x) *
                              static_cast<std::size_t>(constants.tiles_y) * layout::tile * layout::tile;
  need.pixels = samples * pixel_bytes(plan.channels);
  return need;
}

std::string exceeded_limit(const MemoryNeed& need, std::size_t max_allocation) {
  if (need.largest_buffer <= max_allocation) return "";
  return fmt::format("{} need {:.1f} MiB in one piece; the device allocates at most {:.1f} MiB", need.largest_name,
                     static_cast<double>(need.largest_buffer) / 0x1p20, static_cast<double>(max_allocation) / 0x1p20);
}

}  // namespace morphcl
