#include "host/render/frame_tables.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "host/error.hpp"
#include "host/render/raster_grid.hpp"

namespace morphcl {

namespace {

using layout::uint;

template <std::size_t N>
void copy(const std::array<float, N>& from, float* to) {
  std::copy(from.begin(), from.end(), to);
}

uint draw_flags(const Draw& draw) {
  uint flags = 0;
  if (draw.shading == Shading::wireframe) flags |= DRAW_LINES;
  if (draw.shading == Shading::smooth) flags |= DRAW_SMOOTH;
  if (draw.shading == Shading::flat) flags |= DRAW_FLAT;
  if (draw.double_sided) flags |= DRAW_DOUBLE_SIDED;
  if (draw.mirrored) flags |= DRAW_MIRRORED;
  if (draw.vertex_colors) flags |= DRAW_VERTEX_COLORS;
  return flags;
}

layout::DrawConstants make_draw_constants(const Draw& draw, const StoredMesh& mesh, const FrameTables& tables) {
  layout::DrawConstants constants{};
  for (int row = 0; row < 4; ++row) copy(draw.object_to_clip[row], constants.object_to_clip[row]);
  for (int row = 0; row < 3; ++row) copy(draw.object_to_eye[row], constants.object_to_eye[row]);
  for (int row = 0; row < 3; ++row) copy(draw.normal_to_eye[row], constants.normal_to_eye[row]);
  copy(draw.base_color, constants.base_color);
  const StoredMesh::Primitives& primitives = draw.shading == Shading::wireframe ? mesh.edges : mesh.triangles;
  constants.flags = draw_flags(draw);
  constants.first_group = static_cast<uint>(tables.group_draw.size());
  constants.group_count = mesh.vertex_groups;
  constants.first_block = static_cast<uint>(tables.blocks.size());
  constants.block_count = primitives.blocks;
  constants.positions = mesh.positions, constants.normals = mesh.normals, constants.colors = mesh.colors;
  constants.pitch = mesh.pitch;
  constants.indices = primitives.indices, constants.index_pitch = primitives.pitch;
  constants.first_target = static_cast<uint>(tables.targets.size());
  constants.target_count = static_cast<uint>(draw.targets.size());
  return constants;
}

}  // namespace

FrameTables make_frame_tables(const FramePlan& plan, const MeshStore& meshes) {
  FrameTables tables;
  constexpr std::size_t most = (std::size_t{1} << 29) / layout::lanes - 1;
  for (const Draw& draw : plan.draws) {
    const StoredMesh& mesh = meshes.stored(*draw.mesh);
    const layout::DrawConstants constants = make_draw_constants(draw, mesh, tables);
    const uint number = static_cast<uint>(tables.draws.size());
    if (tables.group_draw.size() + constants.group_count > most || tables.blocks.size() + constants.block_count > most)
      throw Error(ErrorKind::bad_input, "", "the frame has more than 536 million vertices or primitives");
    tables.group_draw.insert(tables.group_draw.end(), constants.group_count, number);
    for (uint block = 0; block < constants.block_count; ++block)
      tables.blocks.push_back({number, block * static_cast<uint>(layout::lanes)});
    for (const ActiveTarget& active : draw.targets) {
      const StoredMesh::Target& target = mesh.targets[active.target];
      tables.targets.push_back(
          {active.weight, active.base_weight, target.positions, target.normals, target.colors, {}});
    }
    tables.draws.push_back(constants);
    tables.any_flat |= draw.shading == Shading::flat;
    tables.any_smooth |= draw.shading == Shading::smooth;
    tables.any_colors |= draw.vertex_colors;
  }
  for (const EyeLight& light : plan.lights) {
    layout::LightConstants constants{};
    copy(light.vector, constants.vector);
    copy(light.color, constants.color);
    constants.is_point = light.kind == LightKind::point;
    constants.falloff = light.falloff;
    tables.lights.push_back(constants);
  }
  return tables;
}

layout::FrameConstants make_frame_constants(const FramePlan& plan, std::size_t row_pitch) {
  layout::FrameConstants frame{};
  const RasterGrid grid(plan.width, plan.height);
  copy(plan.ambient, frame.ambient);
  frame.scale_x = grid.scale_x, frame.offset_x = grid.offset_x;
  frame.scale_y = grid.scale_y, frame.offset_y = grid.offset_y;
  frame.guard_x = grid.guard_x, frame.guard_y = grid.guard_y;
  copy(plan.near_plane, frame.near_plane);
  frame.near_w = plan.near_w, frame.near_depth = plan.near_depth;
  frame.far_depth = plan.far_depth, frame.near = plan.near;
  copy(plan.ray, frame.ray);
  frame.width = plan.width, frame.height = plan.height;
  frame.tiles_x = (plan.width + layout::tile - 1) / layout::tile;
  frame.tiles_y = (plan.height + layout::tile - 1) / layout::tile;
  frame.row_pitch = static_cast<uint>(row_pitch);
  const uint tiles = static_cast<uint>(frame.tiles_x * frame.tiles_y);
  frame.tile_step = 197;
  while (std::gcd(frame.tile_step, tiles) != 1) frame.tile_step += 2;
  frame.parallel = plan.parallel;
  frame.light_count = static_cast<uint>(plan.lights.size());
  frame.has_point_lights =
      std::any_of(plan.lights.begin(), plan.lights.end(), [](const EyeLight& l) { return l.kind == LightKind::point; });
  frame.writes_color = plan.color, frame.writes_depth = plan.depth;
  frame.clips = plan.clips;
  return frame;
}

}  // namespace morphcl
