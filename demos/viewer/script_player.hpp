// Hands out the presses of a script one by one.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "demos/viewer/key_script.hpp"

namespace morphcl::viewer {

class ScriptPlayer {
 public:
  explicit ScriptPlayer(std::vector<KeyPress> script) : script_(std::move(script)) {}

  bool done() const { return next_ == script_.size(); }

  std::optional<Key> take_next() {
    if (done()) return std::nullopt;
    const KeyPress& press = script_[next_];
    if (++pressed_ == press.count) {
      ++next_;
      pressed_ = 0;
    }
    return press.key;
  }

 private:
  std::vector<KeyPress> script_;
  std::size_t next_ = 0;  // the press at hand ...
  int pressed_ = 0;       // ... and how often it was handed out
};

}  // namespace morphcl::viewer
