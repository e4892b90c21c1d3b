// Key presses as text, so that a demo runs without a keyboard: "k37,o,w3,e".
//
//   SCRIPT = PRESS { "," PRESS }    blanks around a press are ignored
//   PRESS  = KEY [ COUNT ]          KEY: a name of key_table(); COUNT: 1 to 1,000,000, default 1
//
// A scene that turns does so by its clock in a window; in a script `t` is a tick of it.
#pragma once

#include <string_view>
#include <vector>

#include "demos/viewer/key.hpp"

namespace morphcl::viewer {

struct KeyPress {
  Key key;
  int count;
  bool operator==(const KeyPress&) const = default;
};

constexpr int kMaxPresses = 1'000'000;            // of a whole script
constexpr std::size_t kMaxScriptLength = 65'536;  // characters

// Error(usage) names the press that is wrong, and what would be right.
std::vector<KeyPress> parse_key_script(std::string_view text);

}  // namespace morphcl::viewer
