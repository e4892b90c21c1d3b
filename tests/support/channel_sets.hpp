// Channels that tests ask for.
#pragma once

#include <array>
#include <string>

#include "morphcl/channel.hpp"

namespace morphcl {

constexpr ChannelSet color_alone{Channel::color}, depth_alone{Channel::depth};
constexpr std::array<ChannelSet, 3> choices_of_two{default_channels, color_alone, depth_alone};

// "RGBA Z", for messages.
inline std::string names_of(ChannelSet channels) {
  std::string names;
  for (const Channel channel : channels) names += (names.empty() ? "" : " ") + std::string(name_of(channel));
  return names;
}

}  // namespace morphcl
