#include "demos/viewer/hold_repeat.hpp"

namespace morphcl::viewer {

void HoldRepeat::press(Key key, double now) {
  if (!info(key).repeats) return;
  held_ = key;
  due_ = now + kHoldDelaySeconds;
}

void HoldRepeat::release(Key key) {
  if (held_ == key) held_.reset();
}

std::optional<double> HoldRepeat::next_due() const {
  if (!held_) return std::nullopt;
  return due_;
}

std::optional<Key> HoldRepeat::take_due(double now) {
  if (!held_ || now < due_) return std::nullopt;
  due_ += kHoldPeriodSeconds;
  if (due_ < now) due_ = now + kHoldPeriodSeconds;
  return held_;
}

}  // namespace morphcl::viewer
