#include "host/render/device/channel_tables.hpp"

#include <algorithm>
#include <limits>

#include "host/render/frame/channel_passes.hpp"

namespace morphcl {

namespace {

using layout::uint;

constexpr std::size_t max_id_bytes = std::size_t{64} << 20;

static_assert(CHANNELS == channel_count);
constexpr bool has_number(Channel channel, int number) { return static_cast<int>(channel) == number; }
static_assert(has_number(Channel::normal, CHANNEL_NORMAL) && has_number(Channel::position, CHANNEL_POSITION) &&
              has_number(Channel::velocity, CHANNEL_VELOCITY) && has_number(Channel::uv, CHANNEL_UV) &&
              has_number(Channel::albedo, CHANNEL_ALBEDO) && has_number(Channel::object_id, CHANNEL_OBJECT_ID) &&
              has_number(Channel::material_id, CHANNEL_MATERIAL_ID) &&
              has_number(Channel::coverage, CHANNEL_COVERAGE) &&
              has_number(Channel::crypto_object, CHANNEL_CRYPTO_OBJECT) &&
              has_number(Channel::crypto_material, CHANNEL_CRYPTO_MATERIAL));
static_assert(plane_count(Channel::crypto_object) == 2 * CRYPTO_RANKS);

layout::ChannelConstants make_channel_constants(const FramePlan& plan, const RawFrame& picture) {
  layout::ChannelConstants constants{};
  for (const Channel channel : plan.channels)
    constants.offset[static_cast<std::size_t>(channel)] = static_cast<uint>(picture.plane_offset(channel, 0));
  constants.half_plane = static_cast<uint>(picture.padded_width * sizeof(std::uint16_t));
  constants.word_plane = static_cast<uint>(picture.padded_width * sizeof(uint));
  for (std::size_t row = 0; row < 3; ++row) std::copy_n(plan.eye_to_world[row].begin(), 4, constants.eye_to_world[row]);
  return constants;
}

layout::ChannelDraw make_channel_draw(const Draw& draw, const StoredMesh& mesh) {
  layout::ChannelDraw constants{};
  std::copy_n(draw.albedo.begin(), 3, constants.albedo);
  constants.object_id = draw.object_id;
  constants.material_id = draw.material_id;
  constants.crypto_object = draw.crypto_object;
  constants.crypto_material = draw.crypto_material;
  constants.uvs = mesh.uvs;
  constants.moves = draw.moves;
  return constants;
}

// As the draw is now but for what moves its vertices.
void add_next_draw(const Draw& next, const layout::DrawConstants& now, const StoredMesh& mesh, const MeshStore& meshes,
                   ChannelTables& tables) {
  layout::DrawConstants constants = now;
  for (std::size_t row = 0; row < 4; ++row)
    std::copy_n(next.object_to_clip[row].begin(), 4, constants.object_to_clip[row]);
  constants.positions = next.displaced ? meshes.next_displaced(next.object) : mesh.positions;
  constants.first_target = static_cast<uint>(tables.next_targets.size());
  constants.target_count = static_cast<uint>(next.targets.size());
  for (const ActiveTarget& active : next.targets) {
    const uint positions =
        next.displaced ? layout::no_id : mesh.targets[static_cast<std::size_t>(active.target)].positions;
    tables.next_targets.push_back(
        {active.weight, active.base_weight, positions, layout::no_id, layout::no_id, active.weight_rest, {}});
  }
  constants.precise = static_cast<uint>(tables.next_precise.size());
  constants.flags &= ~(DRAW_PIVOT | DRAW_TWO_FLOAT);
  const VertexForm form = next.accuracy ? next.accuracy->form : VertexForm::plain;
  if (form == VertexForm::pivot) constants.flags |= DRAW_PIVOT;
  if (form == VertexForm::two_float) constants.flags |= DRAW_TWO_FLOAT;
  if (form != VertexForm::plain) {
    layout::PreciseConstants& precise = tables.next_precise.emplace_back();
    std::copy_n(next.accuracy->pivot.begin(), 3, precise.pivot);
    for (std::size_t row = 0; row < 4; ++row)
      std::copy_n(next.accuracy->clip_rest[row].begin(), 4, precise.clip_rest[row]);
  }
  tables.next_draws.push_back(constants);
}

}  // namespace

void make_channel_tables(const FramePlan& plan, const std::vector<layout::DrawConstants>& draws,
                         const MeshStore& meshes, const RawFrame& picture, ChannelTables& tables) {
  tables.draws.clear();
  tables.next_draws.clear();
  tables.next_targets.clear();
  tables.next_precise.clear();
  if ((plan.channels & (channels_of_samples | channels_of_centres)).empty()) return;
  tables.constants = make_channel_constants(plan, picture);
  for (std::size_t i = 0; i < plan.draws.size(); ++i) {
    const StoredMesh& mesh = meshes.stored(*plan.draws[i].mesh);
    tables.draws.push_back(make_channel_draw(plan.draws[i], mesh));
    if (plan.has(Channel::velocity)) add_next_draw(plan.next_draws[i], draws[i], mesh, meshes, tables);
  }
}

std::size_t max_tile_rows(const FramePlan& plan) {
  const bool of_samples = !(plan.channels & channels_of_samples).empty(),
             of_centres = !(plan.channels & channels_of_centres).empty();
  if (!of_samples && !of_centres) return std::numeric_limits<std::size_t>::max();
  const auto tiles_x = static_cast<std::size_t>((plan.width + layout::tile - 1) / layout::tile);
  return std::max<std::size_t>(max_id_bytes / (tiles_x * ids_bytes_of_tile(of_samples ? plan.samples : 1, plan.blends)),
                               1);
}

}  // namespace morphcl
