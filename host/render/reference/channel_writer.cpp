#include "host/render/reference/channel_writer.hpp"

#include <Imath/half.h>

namespace morphcl::reference {

void ChannelWriter::write(Channel channel, std::initializer_list<float> values, int x, int y) const {
  if (!channels_.contains(channel)) return;
  int plane = 0;
  for (const float value : values) {
    if (plane_type(channel) == PixelType::half)
      element<std::uint16_t>(channel, plane, x, y) = imath_float_to_half(value);
    else
      element<float>(channel, plane, x, y) = value;
    ++plane;
  }
}

void ChannelWriter::write(Channel channel, std::uint32_t value, int x, int y) const {
  if (channels_.contains(channel)) element<std::uint32_t>(channel, 0, x, y) = value;
}

void ChannelWriter::write(const Centre& centre, int x, int y) const {
  write(Channel::normal, {centre.normal.x, centre.normal.y, centre.normal.z}, x, y);
  write(Channel::position, {centre.position.x, centre.position.y, centre.position.z}, x, y);
  write(Channel::velocity, {centre.velocity.x, centre.velocity.y}, x, y);
  write(Channel::uv, {centre.uv.x, centre.uv.y}, x, y);
  write(Channel::albedo, {centre.albedo.r, centre.albedo.g, centre.albedo.b}, x, y);
  write(Channel::object_id, centre.object_id, x, y);
  write(Channel::material_id, centre.material_id, x, y);
}

void ChannelWriter::write_shares(const FramePlan& plan, std::span<const Sample> samples, float coverage, int x,
                                 int y) const {
  write(Channel::coverage, {coverage}, x, y);
  for (const auto& [channel, names] : {std::pair{Channel::crypto_object, CryptoNames::objects},
                                       std::pair{Channel::crypto_material, CryptoNames::materials}}) {
    if (!channels_.contains(channel)) continue;
    const CryptoRanks ranks = crypto_ranks_of(plan, samples, names);
    for (int plane = 0; plane < plane_count(channel); ++plane)
      element<float>(channel, plane, x, y) = ranks[static_cast<std::size_t>(plane / 2)][plane % 2 ? 1 : 0];
  }
}

}  // namespace morphcl::reference
