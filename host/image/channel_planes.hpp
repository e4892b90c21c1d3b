// The names of a channel's planes in EXR files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "morphcl/channel.hpp"

namespace morphcl {

struct NamedPlane {
  Channel channel;
  int plane;  // 0 .. plane_count(channel) - 1
  std::string name;
};

// Such as "N.X"; at most 31 characters, so that no file needs OpenEXR's flag for long names.
std::string plane_name(Channel channel, int plane, ChannelNames names);

// All planes of the channels in the order of EXR files: by their names' bytes.
std::vector<NamedPlane> named_planes(ChannelSet channels, ChannelNames names);

// Whether some plane has this name under any of ChannelNames.
bool is_plane_name(std::string_view name);

// The name of the Cryptomatte layer of crypto_object or crypto_material: that of its planes before "00.R".
std::string cryptomatte_layer(Channel channel, ChannelNames names);

}  // namespace morphcl
