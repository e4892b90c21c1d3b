#include "host/image/cryptomatte_attributes.hpp"

#include <ImfChannelList.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include "host/image/exr_planes.hpp"
#include "host/murmur3.hpp"

namespace morphcl {

void add_cryptomatte(Imf::Header& header, const FrameAttributes& attributes) {
  const CryptomatteManifests unknown;
  const CryptomatteManifests& manifests = attributes.manifests ? *attributes.manifests : unknown;
  for (const Channel channel : channels_of(planes_in(header.channels())) & cryptomatte_channels) {
    const std::string layer = cryptomatte_layer(channel, attributes.channel_names);
    const std::string key = fmt::format("cryptomatte/{}/", fmt::format("{:08x}", murmur3_32(layer)).substr(0, 7));
    const std::string& manifest = channel == Channel::crypto_object ? manifests.objects : manifests.materials;
    header.insert(key + "name", Imf::StringAttribute(layer));
    header.insert(key + "hash", Imf::StringAttribute("MurmurHash3_32"));
    header.insert(key + "conversion", Imf::StringAttribute("uint32_to_float32"));
    if (!manifest.empty()) header.insert(key + "manifest", Imf::StringAttribute(manifest));
  }
}

}  // namespace morphcl
