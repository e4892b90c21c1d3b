#include "demos/viewer/key.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace morphcl::viewer {
namespace {

constexpr std::array<KeyInfo, 14> kKeys = {{
    {Key::step_forward, "k", "q", "morph one step forward", true, true},
    {Key::step_back, "p", "", "morph one step back", true, true},
    {Key::play, "space", "", "play, pause", false, true},
    {Key::orthographic, "o", "", "orthographic projection", false, false},
    {Key::frustum, "f", "", "frustum (perspective)", false, false},
    {Key::eye_up, "w", "", "eye up", true, false},
    {Key::eye_down, "s", "", "eye down", true, false},
    {Key::orbit_left, "left", "", "orbit to the left", true, false},
    {Key::orbit_right, "right", "", "orbit to the right", true, false},
    {Key::orbit_up, "up", "", "orbit upwards", true, false},
    {Key::orbit_down, "down", "", "orbit downwards", true, false},
    {Key::help, "h", "", "show or hide the keys", false, false},
    {Key::export_frame, "e", "", "export the frame as EXR", false, false},
    {Key::leave, "esc", "", "leave", false, false},
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
  for (const KeyInfo& entry : kKeys) {
    if (same_letters(name, entry.name) || (!entry.alias.empty() && same_letters(name, entry.alias))) return entry.key;
  }
  return std::nullopt;
}

}  // namespace morphcl::viewer
