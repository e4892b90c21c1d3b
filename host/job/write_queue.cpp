#include "host/job/write_queue.hpp"

#include <utility>

#include "host/threads.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

WriteQueue::WriteQueue(Limits limits, std::function<std::unique_ptr<FrameBuffer>()> make_buffer,
                       std::function<void(FrameTask&, const ReleasePixels&)> write)
    : make_buffer_(std::move(make_buffer)),
      write_(std::move(write)),
      max_waiting_(static_cast<std::size_t>(limits.buffers) + static_cast<std::size_t>(limits.threads)),
      buffers_left_to_make_(limits.buffers) {
  const auto work = [this](int) { write_frames(); };
  const int started = start_threads(threads_, limits.threads, work);
  if (started > 1 && started < limits.threads) {
    // The system has no more to give, and others need some too, as a driver does that links what it compiles.
    join();
    closed_ = false;
    start_threads(threads_, started / 2, work);
  }
  if (threads_.empty())
    throw Error(
        ErrorKind::no_device, "",
        "no thread can be started here to write frames; raise the limit of processes (ulimit -u, pids.max) or of "
        "memory (ulimit -v)");
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

void WriteQueue::put(FrameTask task) {
  {
    std::unique_lock lock(mutex_);
    task_is_taken_.wait(lock, [this] { return tasks_.size() < max_waiting_; });
    tasks_.push_back(std::move(task));
  }
  task_is_there_.notify_one();
}

bool WriteQueue::broken() const {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

void WriteQueue::drain() {
  std::unique_lock lock(mutex_);
  all_done_.wait(lock, [this] { return tasks_.empty() && tasks_in_work_ == 0; });
}

void WriteQueue::finish() {
  join();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void WriteQueue::write_frames() {
  for (;;) {
    std::unique_lock lock(mutex_);
    task_is_there_.wait(lock, [this] { return closed_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    FrameTask task = std::move(tasks_.front());
    tasks_.pop_front();
    ++tasks_in_work_;
    lock.unlock();
    task_is_taken_.notify_one();
    const ReleasePixels release = [&] {
      if (task.pixels) give_back(std::move(task.pixels));
    };
    std::exception_ptr failure;
    try {
      write_(task, release);
    } catch (...) {
      failure = std::current_exception();
    }
    release();
    lock.lock();
    if (!failure_) failure_ = failure;
    if (--tasks_in_work_ == 0 && tasks_.empty()) all_done_.notify_all();
  }
}

void WriteQueue::join() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  task_is_there_.notify_all();
  threads_.clear();  // a jthread joins when it goes
}

}  // namespace morphcl
