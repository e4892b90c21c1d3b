// Plans of a job's frames, made one frame ahead by a thread of their own, while the frame before is drawn.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "host/render/frame/plan_digest.hpp"
#include "morphcl/planner.hpp"

namespace morphcl {

struct PlannedFrame {
  std::int64_t frame = 0;
  std::optional<Plan> plan;
  PlanDigest digest;
  std::exception_ptr failure;  // what the planner threw; there is no plan then
};

PlannedFrame plan_with_digest(const Planner& planner, std::int64_t frame);

class PlanAhead {
 public:
  // Plans `frames` in their order. Both arguments have to outlive this.
  PlanAhead(const Planner& planner, std::span<const std::int64_t> frames);
  ~PlanAhead();  // waits for the plan in the making, no further one is made
  PlanAhead(const PlanAhead&) = delete;
  PlanAhead& operator=(const PlanAhead&) = delete;

  // The next frame's plan; waits for it. To be called at most once for each frame.
  PlannedFrame next();

 private:
  void make_plans();

  const Planner& planner_;
  const std::span<const std::int64_t> frames_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PlannedFrame> ready_;
  bool stopped_ = false;
  std::size_t next_ = 0;               // of frames_, where there is no thread
  std::vector<std::jthread> threads_;  // one, or none where the system starts none: then next() makes the plan
};

}  // namespace morphcl
