// Repeats a key that is held down, by the clock: the same on systems with another key repeat rate, or none.
#pragma once

#include <optional>

#include "demos/viewer/key.hpp"

namespace morphcl::viewer {

constexpr double kHoldDelaySeconds = 0.3;          // from the press to the first repeat
constexpr double kHoldPeriodSeconds = 1.0 / 30.0;  // between repeats: 100 steps take 3.6 s in all

// Times are seconds of one steady clock. The key pressed last is the one that repeats.
class HoldRepeat {
 public:
  void press(Key key, double now);
  void release(Key key);

  // When the next repeat is due; none while no repeating key is held.
  std::optional<double> next_due() const;

  // The key, when its repeat is due at `now`; the one after it is due a period later. At most one a call, and what a
  // slow frame missed is not made up for, so that every step is seen and nothing goes on after the key is released.
  std::optional<Key> take_due(double now);

 private:
  std::optional<Key> held_;
  double due_ = 0;
};

}  // namespace morphcl::viewer
