#include <morphcl/channel.hpp>

bool use_channel() {
  constexpr morphcl::ChannelSet channels{morphcl::Channel::normal, morphcl::Channel::color};
  return morphcl::channel_named("N") == *++channels.begin() && morphcl::pixel_bytes(channels) == 14;
}
