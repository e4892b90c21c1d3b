// The keys of the demos, and the tick of the clock that turns a scene: one table that the keyboard, the scripts and the
// help read.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace morphcl::viewer {

enum class Key {
  step_forward,
  step_back,
  play,
  orthographic,
  frustum,
  eye_up,
  eye_down,
  orbit_left,
  orbit_right,
  orbit_up,
  orbit_down,
  turn,
  tick,
  help,
  export_frame,
  leave
};

struct KeyInfo {
  Key key;
  std::string_view name;   // as scripts write it; a single character is also what the keyboard types; empty: no key
  std::string_view alias;  // another name for the same key, or empty
  std::string_view does;
  bool repeats;      // while it is held down
  bool needs_steps;  // means nothing in a scene of one frame
  bool needs_turn;   // means nothing in a scene that does not turn
};

std::span<const KeyInfo> key_table();
const KeyInfo& info(Key key);

// By name or alias, in either case; none when there is no such key.
std::optional<Key> find_key(std::string_view name);

}  // namespace morphcl::viewer
