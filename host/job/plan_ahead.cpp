#include "host/job/plan_ahead.hpp"

#include <utility>

#include "host/threads.hpp"

namespace morphcl {

PlannedFrame plan_with_digest(const Planner& planner, std::int64_t frame) {
  PlannedFrame planned;
  planned.frame = frame;
  try {
    planned.plan = planner.plan(frame);
    planned.digest = pixel_digest(**planned.plan);
  } catch (...) {
    planned.failure = std::current_exception();
  }
  return planned;
}

PlanAhead::PlanAhead(const Planner& planner, std::span<const std::int64_t> frames)
    : planner_(planner), frames_(frames) {
  start_threads(threads_, 1, [this](int) { make_plans(); });
}

PlanAhead::~PlanAhead() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
}

PlannedFrame PlanAhead::next() {
  if (threads_.empty()) return plan_with_digest(planner_, frames_[next_++]);
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return ready_.has_value(); });
  PlannedFrame planned = std::move(*ready_);
  ready_.reset();
  lock.unlock();
  changed_.notify_all();
  return planned;
}

void PlanAhead::make_plans() {
  for (const std::int64_t frame : frames_) {
    {
      const std::lock_guard lock(mutex_);
      if (stopped_) return;
    }
    PlannedFrame planned = plan_with_digest(planner_, frame);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || !ready_; });
    if (stopped_) return;
    ready_ = std::move(planned);
    lock.unlock();
    changed_.notify_all();
  }
}

}  // namespace morphcl
