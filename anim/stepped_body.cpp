#include "anim/stepped_body.hpp"

#include <algorithm>
#include <utility>

#include "host/math/finite.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

std::int64_t frame_at_or_before(std::int64_t tick, const TimeBase& time) {
  const std::int64_t length = time.ticks_per_frame();
  return tick / length - (tick % length < 0 ? 1 : 0);
}

double step_seconds(const TimeBase& time) {
  return static_cast<double>(time.ticks_per_frame()) /
         static_cast<double>(time.ticks_per_second() * SteppedBody::steps_per_frame);
}

}  // namespace

SteppedBody::SteppedBody(SpringNet net, EdgeRest rest, MorphDrive drive, const TimeBase& time, std::size_t kept_bytes)
    : net_(std::move(net)),
      rest_(rest),
      drive_(std::move(drive)),
      on_springs_(drive_.on_springs()),
      time_(time),
      max_kept_(
          std::max<std::size_t>(kept_bytes / (2 * sizeof(glm::dvec3) * std::max<std::size_t>(net_.masses, 1)), 2)),
      stepper_(net_, rest, step_seconds(time)) {
  const std::int64_t first = drive_.first_tick(), end = drive_.end_tick();
  if (first <= end) {
    first_frame_ = frame_at_or_before(first, time);
    end_frame_ = frame_at_or_before(end, time) + 1;
  }
  if (first > end) still_from_ = first_frame_;
  frame_ = first_frame_;
  rest_at(time.frame_ticks(frame_), state_.position);
  state_.velocity.assign(net_.masses, glm::dvec3(0.0));
  kept_.emplace(frame_, state_);
}

// Where the masses rest while their weights stay as they are at the tick.
void SteppedBody::rest_at(std::int64_t tick, Displacements& out) const {
  out.resize(net_.masses);
  drive_.displacements_at(tick, out);
  if (rest_ == EdgeRest::driven) return;
  Displacements pulls = out;
  for (glm::dvec3& pull : pulls) pull *= net_.anchor;
  StiffnessSolver(net_, 0, 1).solve(pulls, out);
}

void SteppedBody::go_on_one_frame() {
  const std::int64_t start = time_.frame_ticks(frame_), length = time_.ticks_per_frame() / steps_per_frame;
  const bool keys_are_over = frame_ >= end_frame_, driven = !keys_are_over || on_springs_;
  bool moved = false;
  NetState next = state_;
  Displacements from(net_.masses), to(net_.masses);
  drive_.displacements_at(start, from);
  for (int step = 1; step <= steps_per_frame; ++step) {
    if (driven)
      drive_.displacements_at(start + step * length, to);
    else
      to = from;
    stepper_.step(next, from, to);
    moved = moved || from != to;
    from.swap(to);
  }
  if (!std::all_of(next.position.begin(), next.position.end(), [](const glm::dvec3& p) { return is_finite(p); }))
    throw Error(ErrorKind::bad_input, "", "the elastic motion overflows; use smaller weights");
  if (keys_are_over && !moved && next == state_) still_from_ = frame_;
  state_ = std::move(next);
  ++frame_;
}

void SteppedBody::keep() {
  if ((frame_ - first_frame_) % stride_ != 0) return;
  kept_.emplace(frame_, state_);
  while (kept_.size() > max_kept_) {
    stride_ *= 2;
    std::erase_if(kept_, [this](const auto& entry) { return (entry.first - first_frame_) % stride_ != 0; });
  }
}

void SteppedBody::displacements_at(std::int64_t frame, Displacements& out) {
  frame = std::max(frame, first_frame_);
  if (still_from_) frame = std::min(frame, *still_from_);
  const auto kept = std::prev(kept_.upper_bound(frame));
  if (frame_ > frame || kept->first > frame_) {
    frame_ = kept->first;
    state_ = kept->second;
  }
  while (frame_ < frame && !(still_from_ && frame_ >= *still_from_)) {
    go_on_one_frame();
    keep();
  }
  out = state_.position;
}

}  // namespace morphcl
