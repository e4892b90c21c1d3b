#include "host/render/device/frame_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "host/render/frame/raster_grid.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

using layout::uint;

template <std::size_t N>
void copy(const std::array<float, N>& from, float* to) {
  std::copy(from.begin(), from.end(), to);
}

VertexForm form_of(const Draw& draw) { return draw.accuracy ? draw.accuracy->form : VertexForm::plain; }

layout::PreciseConstants make_precise_constants(const VertexAccuracy& accuracy) {
  layout::PreciseConstants constants{};
  copy(accuracy.pivot, constants.pivot);
  for (int row = 0; row < 4; ++row) copy(accuracy.clip_rest[row], constants.clip_rest[row]);
  return constants;
}

uint draw_flags(const Draw& draw) {
  uint flags = 0;
  if (draw.shading == Shading::wireframe) flags |= DRAW_LINES;
  if (draw.shading == Shading::smooth) flags |= DRAW_SMOOTH;
  if (draw.shading == Shading::flat) flags |= DRAW_FLAT;
  if (draw.double_sided) flags |= DRAW_DOUBLE_SIDED;
  if (draw.mirrored) flags |= DRAW_MIRRORED;
  if (draw.vertex_colors) flags |= DRAW_VERTEX_COLORS;
  if (draw.lit_per_pixel) flags |= DRAW_LIT_PER_PIXEL;
  if (draw.blended) flags |= DRAW_BLENDED;
  if (draw.normals == NormalSource::vertices) flags |= DRAW_VERTEX_NORMALS;
  if (draw.normals == NormalSource::faces) flags |= DRAW_FACE_NORMALS;
  if (form_of(draw) == VertexForm::pivot) flags |= DRAW_PIVOT;
  if (form_of(draw) == VertexForm::two_float) flags |= DRAW_TWO_FLOAT;
  return flags;
}

// Groups and targets follow those of the draws before.
layout::DrawConstants make_draw_constants(const Draw& draw, const StoredMesh& mesh, layout::uint positions,
                                          const FrameTables& tables) {
  layout::DrawConstants constants{};
  for (int row = 0; row < 4; ++row) copy(draw.object_to_clip[row], constants.object_to_clip[row]);
  for (int row = 0; row < 3; ++row) copy(draw.object_to_eye[row], constants.object_to_eye[row]);
  for (int row = 0; row < 3; ++row) copy(draw.normal_to_eye[row], constants.normal_to_eye[row]);
  copy(draw.base_color, constants.base_color);
  const StoredMesh::Primitives& primitives = draw.shading == Shading::wireframe ? mesh.edges : mesh.triangles;
  constants.flags = draw_flags(draw);
  constants.vertex_group_count = mesh.vertex_groups;
  constants.primitive_group_count = primitives.groups;
  if (!tables.draws.empty()) {
    const layout::DrawConstants& before = tables.draws.back();
    constants.first_vertex_group = before.first_vertex_group + before.vertex_group_count;
    constants.first_primitive_group = before.first_primitive_group + before.primitive_group_count;
  }
  constexpr std::size_t max_groups = (std::size_t{1} << (32 - layout::piece_bits)) / layout::lanes - 1;
  if (std::size_t{constants.first_vertex_group} + constants.vertex_group_count > max_groups ||
      std::size_t{constants.first_primitive_group} + constants.primitive_group_count > max_groups)
    throw Error(ErrorKind::bad_input, "", "the frame has more than 536 million vertices or primitives");
  constants.positions = positions;
  constants.normals = mesh.normals;
  constants.colors = mesh.colors;
  constants.pitch = mesh.pitch;
  constants.indices = primitives.indices;
  constants.index_pitch = primitives.pitch;
  constants.first_target = static_cast<uint>(tables.targets.size());
  constants.target_count = static_cast<uint>(draw.targets.size());
  constants.precise = static_cast<uint>(tables.precise.size());
  constants.line_width = draw.line_width;
  constants.alpha_cutoff = draw.alpha_cutoff;
  return constants;
}

layout::LightConstants make_light_constants(const EyeLight& light) {
  layout::LightConstants constants{};
  copy(light.vector, constants.vector);
  copy(light.color, constants.color);
  constants.is_point = light.kind == LightKind::point;
  constants.falloff = light.falloff;
  constants.has_cone = light.cone_scale > 0;
  constants.cone_scale = light.cone_scale;
  constants.cone_offset = light.cone_offset;
  copy(light.beam, constants.beam);
  return constants;
}

// A step through the tiles of a band that comes to each of them, whichever band it is: all have as many but the last.
uint tile_step(const std::vector<DevicePicture::Band>& bands) {
  uint step = 197;
  while (std::gcd(step, bands.front().tiles) != 1 || std::gcd(step, bands.back().tiles) != 1) step += 2;
  return step;
}

layout::FrameConstants make_frame_constants(const FramePlan& plan, const DevicePicture& picture) {
  layout::FrameConstants frame{};
  const RasterGrid grid(plan.width, plan.height);
  copy(plan.ambient, frame.ambient);
  frame.scale_x = grid.scale_x;
  frame.offset_x = grid.offset_x;
  frame.scale_y = grid.scale_y;
  frame.offset_y = grid.offset_y;
  frame.guard_x = grid.guard_x;
  frame.guard_y = grid.guard_y;
  frame.camera = plan.camera;
  frame.width = plan.width;
  frame.height = plan.height;
  frame.tiles_x = (plan.width + layout::tile - 1) / layout::tile;
  frame.tiles_y = (plan.height + layout::tile - 1) / layout::tile;
  frame.row_bytes = static_cast<uint>(picture.memory.row_bytes);
  for (int plane = 0; plane < 4; ++plane)
    frame.color_offset[plane] = static_cast<uint>(picture.memory.plane_offset(Channel::color, plane));
  frame.depth_offset = static_cast<uint>(picture.memory.plane_offset(Channel::depth, 0));
  frame.notes_offset = static_cast<uint>(picture.memory.notes_offset);
  frame.tile_step = tile_step(picture.bands);
  frame.light_count = static_cast<uint>(plan.lights.size());
  frame.has_point_lights =
      std::any_of(plan.lights.begin(), plan.lights.end(), [](const EyeLight& l) { return l.kind == LightKind::point; });
  frame.writes_color = plan.has_color();
  frame.writes_depth = plan.has_depth();
  frame.clips = plan.clips;
  frame.divides = plan.divides;
  frame.tests_depth = plan.tests_depth;
  frame.blends = plan.blends;
  frame.has_background = plan.background != nullptr;
  frame.keeps_blank_tiles = plan.keeps_blank_tiles && !plan.background;
  return frame;
}

// How far a draw's middle lies from the eye, in any unit.
float distance_of(const Draw& draw, const StoredMesh& mesh, bool parallel) {
  const Row& row = draw.object_to_clip[parallel ? 2 : 3];
  glm::vec3 middle = mesh.middle;
  if (draw.accuracy) middle -= glm::vec3(draw.accuracy->pivot[0], draw.accuracy->pivot[1], draw.accuracy->pivot[2]);
  const float along = row[0] * middle.x + row[1] * middle.y + row[2] * middle.z + row[3];
  const float distance = parallel ? -along : along;
  return std::isnan(distance) ? 0.0f : distance;
}

// Numbers all primitive groups in the order of binning, near draws first.
void order_by_distance(std::vector<std::pair<float, uint>>& nearest_first, std::vector<layout::DrawConstants>& draws) {
  std::sort(nearest_first.begin(), nearest_first.end());
  uint order = 0;
  for (const auto& [distance, draw] : nearest_first) {
    draws[draw].first_in_order = order;
    order += draws[draw].primitive_group_count;
  }
}

void add_targets(const Draw& draw, const StoredMesh& mesh, std::vector<layout::TargetConstants>& targets) {
  for (const ActiveTarget& active : draw.targets) {
    const StoredMesh::Target& target = mesh.targets[active.target];
    const uint positions = draw.displaced ? layout::no_id : target.positions;
    targets.push_back(
        {active.weight, active.base_weight, positions, target.normals, target.colors, active.weight_rest, {}});
  }
}

void make_draws(const FramePlan& plan, const MeshStore& meshes, FrameTables& tables) {
  tables.draws.clear();
  tables.targets.clear();
  tables.precise.clear();
  tables.displaced.clear();
  tables.any_flat = tables.any_smooth = tables.any_colors = tables.any_attributes = false;
  tables.only_faces = true;
  std::vector<std::pair<float, uint>> distances;
  distances.reserve(plan.draws.size());
  const Mesh* drawn = nullptr;
  const StoredMesh* mesh = nullptr;
  for (const Draw& draw : plan.draws) {
    if (draw.mesh != drawn) {
      mesh = &meshes.stored(*draw.mesh);
      drawn = draw.mesh;
    }
    distances.emplace_back(distance_of(draw, *mesh, plan.camera.parallel), static_cast<uint>(tables.draws.size()));
    const uint positions = draw.displaced ? meshes.displaced(draw.object) : mesh->positions;
    tables.draws.push_back(make_draw_constants(draw, *mesh, positions, tables));
    tables.displaced.push_back(draw.displaced ? draw.displaced->hash : FrameTables::PositionsHash{});
    add_targets(draw, *mesh, tables.targets);
    if (form_of(draw) != VertexForm::plain) tables.precise.push_back(make_precise_constants(*draw.accuracy));
    tables.any_flat |= draw.shading == Shading::flat;
    tables.any_smooth |= draw.shading == Shading::smooth;
    tables.any_colors |= draw.vertex_colors;
    tables.any_attributes |= draw.normals != NormalSource::none;
    tables.only_faces &= draw.shading == Shading::flat && !draw.vertex_colors && !draw.lit_per_pixel && !draw.blended;
  }
  tables.any_attributes |= tables.any_flat || tables.any_smooth;
  order_by_distance(distances, tables.draws);
}

void renew_targets(const FramePlan& plan, const MeshStore& meshes, FrameTables& tables) {
  tables.targets.clear();
  const Mesh* drawn = nullptr;
  const StoredMesh* mesh = nullptr;
  for (const Draw& draw : plan.draws) {
    if (draw.targets.empty()) continue;
    if (draw.mesh != drawn) {
      mesh = &meshes.stored(*draw.mesh);
      drawn = draw.mesh;
    }
    add_targets(draw, *mesh, tables.targets);
  }
}

template <uint layout::DrawConstants::* count>
std::vector<uint> numbers_of_draws(const std::vector<layout::DrawConstants>& draws) {
  std::vector<uint> numbers;
  for (std::size_t draw = 0; draw < draws.size(); ++draw)
    numbers.insert(numbers.end(), draws[draw].*count, static_cast<uint>(draw));
  return numbers;
}

}  // namespace

void make_frame_tables(const FramePlan& plan, const MeshStore& meshes, const DevicePicture& picture,
                       FrameTables& tables) {
  const DrawsOrigin origin{plan.planner, plan.draws_version};
  if (origin.version != 0 && tables.origin == origin) {
    renew_targets(plan, meshes, tables);
  } else {
    tables.origin = {};
    make_draws(plan, meshes, tables);
    tables.origin = origin;
  }
  make_channel_tables(plan, tables.draws, meshes, picture.memory, tables.channels);
  tables.background = plan.background;
  tables.lights.clear();
  for (const EyeLight& light : plan.lights) tables.lights.push_back(make_light_constants(light));
  tables.frame = make_frame_constants(plan, picture);
  tables.frame.only_faces = tables.only_faces;
  if (!tables.draws.empty()) {
    const layout::DrawConstants& last = tables.draws.back();
    tables.frame.vertex_group_count = last.first_vertex_group + last.vertex_group_count;
    tables.frame.primitive_group_count = last.first_primitive_group + last.primitive_group_count;
  }
}

std::vector<uint> draw_of_vertex_groups(const std::vector<layout::DrawConstants>& draws) {
  return numbers_of_draws<&layout::DrawConstants::vertex_group_count>(draws);
}

std::vector<uint> draw_of_primitive_groups(const std::vector<layout::DrawConstants>& draws) {
  return numbers_of_draws<&layout::DrawConstants::primitive_group_count>(draws);
}

std::vector<uint> draw_in_order(const std::vector<layout::DrawConstants>& draws) {
  std::vector<uint> numbers;
  if (!draws.empty()) numbers.resize(draws.back().first_primitive_group + draws.back().primitive_group_count);
  for (std::size_t draw = 0; draw < draws.size(); ++draw)
    std::fill_n(numbers.begin() + draws[draw].first_in_order, draws[draw].primitive_group_count,
                static_cast<uint>(draw));
  return numbers;
}

}  // namespace morphcl
