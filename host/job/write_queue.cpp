#include "host/job/write_queue.hpp"

#include <utility>

namespace morphcl {

WriteQueue::WriteQueue(int buffers, int threads, std::function<std::unique_ptr<FrameBuffer>()> make_buffer,
                       std::function<void(DrawnFrame&)> write)
    : make_buffer_(std::move(make_buffer)), write_(std::move(write)), buffers_left_to_make_(buffers) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { write_frames(); });
}

WriteQueue::~WriteQueue() { join(); }

std::unique_ptr<FrameBuffer> WriteQueue::take_buffer() {
  std::unique_lock lock(mutex_);
  buffer_is_free_.wait(lock, [this] { return !free_.empty() || buffers_left_to_make_ > 0; });
  if (free_.empty()) {
    std::unique_ptr<FrameBuffer> buffer = make_buffer_();
    --buffers_left_to_make_;
    return buffer;
  }
  std::unique_ptr<FrameBuffer> buffer = std::move(free_.back());
  free_.pop_back();
  return buffer;
}

void WriteQueue::give_back(std::unique_ptr<FrameBuffer> buffer) {
  {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(buffer));
  }
  buffer_is_free_.notify_one();
}

void WriteQueue::put(DrawnFrame frame) {
  {
    const std::lock_guard lock(mutex_);
    frames_.push_back(std::move(frame));
  }
  frame_is_there_.notify_one();
}

bool WriteQueue::broken() const {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

void WriteQueue::finish() {
  join();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void WriteQueue::write_frames() {
  for (;;) {
    std::unique_lock lock(mutex_);
    frame_is_there_.wait(lock, [this] { return closed_ || !frames_.empty(); });
    if (frames_.empty()) return;
    DrawnFrame frame = std::move(frames_.front());
    frames_.pop_front();
    lock.unlock();
    try {
      write_(frame);
    } catch (...) {
      const std::lock_guard failure_lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    give_back(std::move(frame.pixels));
  }
}

void WriteQueue::join() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  frame_is_there_.notify_all();
  threads_.clear();  // a jthread joins when it goes
}

}  // namespace morphcl
