#include "demos/viewer/key.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace morphcl::viewer {
namespace {

constexpr std::array<KeyInfo, 16> kKeys = {{
    {Key::step_forward, "k", "q", "morph one step forward", true, true, false},
    {Key::step_back, "p", "", "morph one step back", true, true, false},
    {Key::play, "space", "", "play, pause", false, true, false},
    {Key::orthographic, "o", "", "orthographic projection", false, false, false},
    {Key::frustum, "f", "", "frustum (perspective)", false, false, false},
    {Key::eye_up, "w", "", "eye up", true, false, false},
    {Key::eye_down, "s", "", "eye down", true, false, false},
    {Key::orbit_left, "left", "", "orbit to the left", true, false, false},
    {Key::orbit_right, "right", "", "orbit to the right", true, false, false},
    {Key::orbit_up, "up", "", "orbit upwards", true, false, false},
    {Key::orbit_down, "down", "", "orbit downwards", true, false, false},
    {Key::turn, "t", "", "stop turning, go on; t120 in a script: 120 ticks", false, false, true},
    {Key::tick, "", "", "", false, false, true},
    {Key::help, "h", "", "show or hide the keys", false, false, false},
    {Key::export_frame, "e", "", "export the frame as EXR", false, false, false},
    {Key::leave, "esc", "", "leave", false, false, false},
}};

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::span<const KeyInfo> key_table() { return kKeys; }

const KeyInfo& info(Key key) {
  return *std::ranges::find(kKeys, key, &KeyInfo::key);  // every key is in the table
}

std::optional<Key> find_key(std::string_view name) {
  if (name.empty()) return std::nullopt;
  for (const KeyInfo& entry : kKeys) {
    if (same_letters(name, entry.name) || same_letters(name, entry.alias)) return entry.key;
  }
  return std::nullopt;
}

}  // namespace morphcl::viewer
