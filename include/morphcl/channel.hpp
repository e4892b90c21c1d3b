// The channels of a frame: what a picture says of each pixel, and sets of them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#pragma GCC visibility push(default)
namespace morphcl {

// Each with its planes (docs/channels.md), in the order in which a row of a frame's memory holds them.
enum class Channel : std::uint8_t {
  color,           // R G B A: scene-linear, premultiplied by alpha
  depth,           // Z: distance along the view axis
  normal,          // N.X N.Y N.Z: world space, unit length
  position,        // P.X P.Y P.Z: world space
  velocity,        // velocity.u velocity.v: pixels from this frame to the next, u right, v up
  uv,              // uv.u uv.v: texture coordinates of the mesh, v up
  albedo,          // albedo.R albedo.G albedo.B: base colour times vertex colours, scene-linear
  object_id,       // object_id: 0 nothing, i + 1 the scene's object i
  material_id,     // material_id: 0 nothing, i + 1 the i-th of the scene's materials
  coverage,        // coverage: the share of the pixel's samples that show something
  crypto_object,   // crypto_object00.R .G .B .A to crypto_object02: id, share, id, share; six ranks
  crypto_material  // crypto_material00.R to crypto_material02.A: the same
};
constexpr std::size_t channel_count = 12;

// The types of pixels, by OpenEXR's numbers.
enum class PixelType : std::uint32_t { uint = 0, half = 1, float_ = 2 };
constexpr std::size_t bytes_of(PixelType type) { return type == PixelType::half ? 2 : 4; }

struct ChannelShape {
  std::string_view name;  // in shots and options
  int planes;
  PixelType type;  // of each plane
};
constexpr std::array<ChannelShape, channel_count> channel_shapes{{{"RGBA", 4, PixelType::half},
                                                                  {"Z", 1, PixelType::float_},
                                                                  {"N", 3, PixelType::half},
                                                                  {"P", 3, PixelType::float_},
                                                                  {"velocity", 2, PixelType::float_},
                                                                  {"uv", 2, PixelType::float_},
                                                                  {"albedo", 3, PixelType::half},
                                                                  {"object_id", 1, PixelType::uint},
                                                                  {"material_id", 1, PixelType::uint},
                                                                  {"coverage", 1, PixelType::float_},
                                                                  {"crypto_object", 12, PixelType::float_},
                                                                  {"crypto_material", 12, PixelType::float_}}};

constexpr const ChannelShape& shape_of(Channel channel) { return channel_shapes[static_cast<std::size_t>(channel)]; }
constexpr std::string_view name_of(Channel channel) { return shape_of(channel).name; }
constexpr int plane_count(Channel channel) { return shape_of(channel).planes; }
constexpr PixelType plane_type(Channel channel) { return shape_of(channel).type; }
constexpr std::size_t pixel_bytes(Channel channel) {  // of all its planes
  return static_cast<std::size_t>(plane_count(channel)) * bytes_of(plane_type(channel));
}
// Nothing for another name. Names are case-sensitive.
constexpr std::optional<Channel> channel_named(std::string_view name) {
  for (std::size_t i = 0; i < channel_count; ++i)
    if (channel_shapes[i].name == name) return static_cast<Channel>(i);
  return std::nullopt;
}

// A set of channels, in the order of Channel. A value: copies are free.
class ChannelSet {
 public:
  class Iterator {
   public:
    constexpr explicit Iterator(std::uint32_t bits) : bits_(bits) {}
    constexpr Channel operator*() const { return static_cast<Channel>(std::countr_zero(bits_)); }
    constexpr Iterator& operator++() {
      bits_ &= bits_ - 1;
      return *this;
    }
    bool operator==(const Iterator&) const = default;

   private:
    std::uint32_t bits_;  // those that are still to come
  };

  constexpr ChannelSet() = default;
  constexpr ChannelSet(std::initializer_list<Channel> channels) {
    for (const Channel channel : channels) insert(channel);
  }

  constexpr bool contains(Channel channel) const { return (bits_ & bit(channel)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr int size() const {
    int count = 0;  // not std::popcount, which calls GCC's library where the processor need not have it
    for (Iterator i = begin(); i != end(); ++i) ++count;
    return count;
  }
  constexpr void insert(Channel channel) { bits_ |= bit(channel); }
  constexpr void erase(Channel channel) { bits_ &= ~bit(channel); }
  constexpr void set(Channel channel, bool is_in) {
    erase(channel);
    if (is_in) insert(channel);
  }

  constexpr ChannelSet operator|(ChannelSet other) const { return ChannelSet(bits_ | other.bits_); }   // union
  constexpr ChannelSet operator&(ChannelSet other) const { return ChannelSet(bits_ & other.bits_); }   // intersection
  constexpr ChannelSet operator-(ChannelSet other) const { return ChannelSet(bits_ & ~other.bits_); }  // difference
  bool operator==(const ChannelSet&) const = default;
  constexpr std::uint32_t bits() const { return bits_; }  // bit i: the i-th of Channel

  constexpr Iterator begin() const { return Iterator(bits_); }
  constexpr Iterator end() const { return Iterator(0); }

 private:
  constexpr explicit ChannelSet(std::uint32_t bits) : bits_(bits) {}
  static constexpr std::uint32_t bit(Channel channel) { return 1u << static_cast<unsigned>(channel); }
  std::uint32_t bits_ = 0;
};

constexpr std::size_t pixel_bytes(ChannelSet channels) {
  std::size_t bytes = 0;
  for (const Channel channel : channels) bytes += pixel_bytes(channel);
  return bytes;
}

constexpr ChannelSet every_channel = [] {
  ChannelSet channels;
  for (std::size_t i = 0; i < channel_count; ++i) channels.insert(static_cast<Channel>(i));
  return channels;
}();
constexpr ChannelSet default_channels{Channel::color, Channel::depth};
// What holds names by their hash, which no pixel may round.
constexpr ChannelSet cryptomatte_channels{Channel::crypto_object, Channel::crypto_material};

// What EXR files call the planes (docs/channels.md): N.X and so on, or as Blender or Nuke reads them by itself. Pixel
// hashes know the plain names alone.
enum class ChannelNames : std::uint8_t { plain, blender, nuke };
constexpr std::array<std::string_view, 3> channel_names_names{"plain", "blender", "nuke"};
constexpr std::string_view name_of(ChannelNames names) { return channel_names_names[static_cast<std::size_t>(names)]; }
// Nothing for another name.
constexpr std::optional<ChannelNames> channel_names_named(std::string_view name) {
  for (std::size_t i = 0; i < channel_names_names.size(); ++i)
    if (channel_names_names[i] == name) return static_cast<ChannelNames>(i);
  return std::nullopt;
}

}  // namespace morphcl
#pragma GCC visibility pop
