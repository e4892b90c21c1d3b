// What a job has drawn and not written yet.
#pragma once

#include <cstddef>
#include <mutex>
#include <set>

#include "morphcl/job.hpp"

namespace morphcl::cli {

// For several threads.
class FramesInWork {
 public:
  void drawn(std::int64_t frame) {
    const std::lock_guard lock(mutex_);
    unwritten_.insert(frame);
  }
  void reported(const FrameResult& result) {
    const std::lock_guard lock(mutex_);
    unwritten_.erase(result.frame);
    if (result.status != FrameResult::Status::failed) ++whole_;
  }

  bool none() const {
    const std::lock_guard lock(mutex_);
    return unwritten_.empty();
  }
  std::size_t whole() const {
    const std::lock_guard lock(mutex_);
    return whole_;
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::int64_t> unwritten_;
  std::size_t whole_ = 0;
};

}  // namespace morphcl::cli
