// Frames on their way from the renderer to the disk, with a bounded number in memory.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "host/job/equal_frames.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/job.hpp"

namespace morphcl {

struct FrameTask {
  FrameResult result;
  FrameAttributes attributes;
  PlanDigest picture;
  std::unique_ptr<FrameBuffer> pixels;  // none: the frame is a copy of `source`
  WrittenFrameFuture source;
  WrittenFramePromise written;  // of a drawn frame: for its copies
};

class WriteQueue {
 public:
  // Lets a task's pixels go to the next frame, when they have been encoded and what is left to do takes none of them.
  using ReleasePixels = std::function<void()>;

  struct Limits {
    int buffers = 1;  // frame buffers at most, made by `make_buffer` when first needed and used again
    int threads = 1;  // that run `write` on the tasks, in the order in which they were put
  };
  // With fewer threads where the system starts no more; Error(no_device) where it starts none.
  WriteQueue(Limits limits, std::function<std::unique_ptr<FrameBuffer>()> make_buffer,
             std::function<void(FrameTask&, const ReleasePixels&)> write);
  ~WriteQueue();  // waits for the tasks that were put
  WriteQueue(const WriteQueue&) = delete;
  WriteQueue& operator=(const WriteQueue&) = delete;

  std::unique_ptr<FrameBuffer> take_buffer();  // waits until one is free
  void give_back(std::unique_ptr<FrameBuffer> buffer);
  void put(FrameTask task);  // waits while one task for each thread and buffer is waiting

  // Whether `write` has thrown: no use in drawing more.
  bool broken() const;
  // Waits until all that was put is written.
  void drain();
  // The same for the last time; throws what `write` threw first.
  void finish();

 private:
  void write_frames();
  void join();

  const std::function<std::unique_ptr<FrameBuffer>()> make_buffer_;
  const std::function<void(FrameTask&, const ReleasePixels&)> write_;
  const std::size_t max_waiting_;
  mutable std::mutex mutex_;
  std::condition_variable buffer_is_free_, task_is_there_, task_is_taken_, all_done_;
  std::vector<std::unique_ptr<FrameBuffer>> free_;
  std::deque<FrameTask> tasks_;
  int buffers_left_to_make_, tasks_in_work_ = 0;
  bool closed_ = false;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_;
};

}  // namespace morphcl
