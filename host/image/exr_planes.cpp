#include "host/image/exr_planes.hpp"

#include <algorithm>
#include <utility>

namespace morphcl {

namespace {

Imf::PixelType imf_type(Channel channel) { return static_cast<Imf::PixelType>(plane_type(channel)); }
static_assert(static_cast<int>(PixelType::uint) == Imf::UINT && static_cast<int>(PixelType::half) == Imf::HALF &&
              static_cast<int>(PixelType::float_) == Imf::FLOAT);

bool holds(const std::vector<NamedPlane>& planes, Channel channel, int plane) {
  return std::ranges::any_of(planes,
                             [&](const NamedPlane& one) { return one.channel == channel && one.plane == plane; });
}

// Alpha that a file lacks is 1.
double missing_value(Channel channel, int plane) { return channel == Channel::color && plane == 3 ? 1 : 0; }

void insert(Imf::FrameBuffer& slices, const FrameBuffer& frame, const NamedPlane& plane, int first_x, int first_y) {
  const Imath::Box2i window({first_x, first_y}, {first_x + frame.width() - 1, first_y + frame.height() - 1});
  slices.insert(plane.name,
                Imf::Slice::Make(imf_type(plane.channel), frame.plane_row(plane.channel, plane.plane, 0).data(), window,
                                 bytes_of(plane_type(plane.channel)), frame.row_bytes(), 1, 1,
                                 missing_value(plane.channel, plane.plane)));
}

}  // namespace

Imf::ChannelList channel_list(const std::vector<NamedPlane>& planes) {
  Imf::ChannelList channels;
  for (const NamedPlane& plane : planes) channels.insert(plane.name, Imf::Channel(imf_type(plane.channel)));
  return channels;
}

std::vector<NamedPlane> planes_in(const Imf::ChannelList& channels) {
  std::vector<NamedPlane> planes;
  for (const Channel channel : every_channel)
    for (const ChannelNames names : {ChannelNames::plain, ChannelNames::blender, ChannelNames::nuke}) {
      const std::size_t before = planes.size();
      for (NamedPlane& plane : named_planes({channel}, names))
        if (channels.findChannel(plane.name)) planes.push_back(std::move(plane));
      if (planes.size() > before) break;
    }
  std::ranges::sort(planes, {}, &NamedPlane::name);
  return planes;
}

ChannelSet channels_of(const std::vector<NamedPlane>& planes) {
  ChannelSet channels;
  for (const NamedPlane& plane : planes) channels.insert(plane.channel);
  return channels;
}

Imf::FrameBuffer slices_to_read(FrameBuffer& frame, const std::vector<NamedPlane>& planes, int first_x, int first_y) {
  frame.data();  // what is known about blank tiles is so no longer
  Imf::FrameBuffer slices;
  for (const NamedPlane& plane : planes) insert(slices, frame, plane, first_x, first_y);
  for (const NamedPlane& plane : named_planes(frame.channels(), ChannelNames::plain))
    if (!holds(planes, plane.channel, plane.plane)) insert(slices, frame, plane, first_x, first_y);
  return slices;
}

Imf::FrameBuffer slices_to_write(const FrameBuffer& frame, const std::vector<NamedPlane>& planes) {
  Imf::FrameBuffer slices;
  for (const NamedPlane& plane : planes) insert(slices, frame, plane, 0, 0);
  return slices;
}

}  // namespace morphcl
