#include "host/job/equal_frames.hpp"

#include <chrono>

namespace morphcl {

namespace {

bool has_failed(const WrittenFrameFuture& frame) {
  if (frame.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  try {
    return frame.get().file_hash.empty();
  } catch (const std::future_error&) {
    return true;  // given up before it was written
  }
}

}  // namespace

std::variant<WrittenFrameFuture, WrittenFramePromise> EqualFrames::find_or_claim(const PlanDigest& picture) {
  const auto found = frames_.find(picture);
  if (found != frames_.end() && !has_failed(found->second)) return found->second;
  WrittenFramePromise promise;
  frames_[picture] = promise.get_future().share();
  order_.push_back(picture);
  if (order_.size() > max_frames) {
    frames_.erase(order_.front());
    order_.pop_front();
  }
  return promise;
}

void EqualFrames::forget(const PlanDigest& picture) { frames_.erase(picture); }

}  // namespace morphcl
