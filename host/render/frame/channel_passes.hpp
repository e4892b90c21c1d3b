// Which pass over a picture each channel comes from.
#pragma once

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

// Beside colour and distance: from what the samples of pixels show, and from what their centres show.
constexpr ChannelSet channels_of_samples{Channel::coverage, Channel::crypto_object, Channel::crypto_material};
constexpr ChannelSet channels_of_centres{Channel::normal, Channel::position,  Channel::velocity,   Channel::uv,
                                         Channel::albedo, Channel::object_id, Channel::material_id};

// Of a frame of several samples a pixel: whether some channel is that of the centres, which are then a pass of their
// own.
inline bool draws_centres(const FramePlan& plan) {
  return !(plan.channels & (channels_of_centres | ChannelSet{Channel::depth})).empty();
}

}  // namespace morphcl
