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

#include "host/image/frame_attributes.hpp"
#include "host/image/frame_buffer.hpp"
#include "host/job/render_job.hpp"

namespace morphcl {

struct DrawnFrame {
  std::unique_ptr<FrameBuffer> pixels;
  FrameAttributes attributes;
  FrameResult result;
};

class WriteQueue {
 public:
  // At most `buffers` (>= 1) frame buffers, made by `make_buffer` when first needed and used again; `threads` (>= 1)
  // run `write` on the frames.
  WriteQueue(int buffers, int threads, std::function<std::unique_ptr<FrameBuffer>()> make_buffer,
             std::function<void(DrawnFrame&)> write);
  ~WriteQueue();  // waits for the frames that were put
  WriteQueue(const WriteQueue&) = delete;
  WriteQueue& operator=(const WriteQueue&) = delete;

  std::unique_ptr<FrameBuffer> take_buffer();  // waits until one is free
  void give_back(std::unique_ptr<FrameBuffer> buffer);
  void put(DrawnFrame frame);

  // Whether `write` has thrown: no use in drawing more.
  bool broken() const;
  // Waits until everything is written; throws what `write` threw first.
  void finish();

 private:
  void write_frames();
  void join();

  const std::function<std::unique_ptr<FrameBuffer>()> make_buffer_;
  const std::function<void(DrawnFrame&)> write_;
  mutable std::mutex mutex_;
  std::condition_variable buffer_is_free_, frame_is_there_;
  std::vector<std::unique_ptr<FrameBuffer>> free_;
  std::deque<DrawnFrame> frames_;
  int buffers_left_to_make_;
  bool closed_ = false;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_;
};

}  // namespace morphcl
