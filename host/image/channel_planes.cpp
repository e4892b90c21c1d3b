#include "host/image/channel_planes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace morphcl {

namespace {

// A plane's name is the stem, and a dot and a letter where there are letters.
struct Stem {
  std::string_view stem, letters;
};
using Stems = std::array<Stem, channel_count>;

constexpr Stems plain_stems{{{"", "RGBA"},
                             {"", "Z"},
                             {"N", "XYZ"},
                             {"P", "XYZ"},
                             {"velocity", "uv"},
                             {"uv", "uv"},
                             {"albedo", "RGB"},
                             {"object_id", ""},
                             {"material_id", ""},
                             {"coverage", ""},
                             {"crypto_object", "RGBA"},
                             {"crypto_material", "RGBA"}}};

// The passes of a view layer as Blender's own files have them; "Velocity" and "Coverage" are passes it does not make.
constexpr Stems blender_stems{{{"ViewLayer.Combined", "RGBA"},
                               {"ViewLayer.Depth", "Z"},
                               {"ViewLayer.Normal", "XYZ"},
                               {"ViewLayer.Position", "XYZ"},
                               {"ViewLayer.Velocity", "XY"},
                               {"ViewLayer.UV", "UV"},
                               {"ViewLayer.DiffCol", "RGB"},
                               {"ViewLayer.IndexOB", "X"},
                               {"ViewLayer.IndexMA", "X"},
                               {"ViewLayer.Coverage", "X"},
                               {"ViewLayer.CryptoObject", "RGBA"},
                               {"ViewLayer.CryptoMaterial", "RGBA"}}};

// Nuke's layers depth and forward, which its nodes take by themselves; a channel without a layer would come to "other".
constexpr Stems nuke_stems{{{"", "RGBA"},
                            {"depth", "Z"},
                            {"N", "XYZ"},
                            {"P", "XYZ"},
                            {"forward", "uv"},
                            {"uv", "uv"},
                            {"albedo", "RGB"},
                            {"other.object_id", ""},
                            {"other.material_id", ""},
                            {"other.coverage", ""},
                            {"crypto_object", "RGBA"},
                            {"crypto_material", "RGBA"}}};

const Stem& stem_of(Channel channel, ChannelNames names) {
  const Stems& stems = names == ChannelNames::blender ? blender_stems
                       : names == ChannelNames::nuke  ? nuke_stems
                                                      : plain_stems;
  return stems[static_cast<std::size_t>(channel)];
}

}  // namespace

std::string plane_name(Channel channel, int plane, ChannelNames names) {
  const auto& [stem, letters] = stem_of(channel, names);
  if (letters.empty()) return std::string(stem);
  const auto at = static_cast<std::size_t>(plane);
  if (cryptomatte_channels.contains(channel)) return fmt::format("{}{:02}.{}", stem, at / 4, letters[at % 4]);
  return stem.empty() ? std::string(1, letters[at]) : fmt::format("{}.{}", stem, letters[at]);
}

std::vector<NamedPlane> named_planes(ChannelSet channels, ChannelNames names) {
  std::vector<NamedPlane> planes;
  for (const Channel channel : channels)
    for (int plane = 0; plane < plane_count(channel); ++plane)
      planes.push_back({channel, plane, plane_name(channel, plane, names)});
  std::ranges::sort(planes, {}, &NamedPlane::name);
  return planes;
}

bool is_plane_name(std::string_view name) {
  static const std::set<std::string, std::less<>> all = [] {
    std::set<std::string, std::less<>> found;
    for (const ChannelNames names : {ChannelNames::plain, ChannelNames::blender, ChannelNames::nuke})
      for (NamedPlane& plane : named_planes(every_channel, names)) found.insert(std::move(plane.name));
    return found;
  }();
  return all.contains(name);
}

std::string cryptomatte_layer(Channel channel, ChannelNames names) { return std::string(stem_of(channel, names).stem); }

}  // namespace morphcl
