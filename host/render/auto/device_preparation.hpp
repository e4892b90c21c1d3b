// The thread that gets a device ready beside the frames: opens it, has kernels compiled, stores them.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "host/render/auto/frame_kernels.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

// For one thread; the const members for any.
class DevicePreparation {
 public:
  using Open = std::function<std::shared_ptr<Session>()>;

  // `open` is called once, by the thread.
  explicit DevicePreparation(Open open) : open_(std::move(open)) {}
  // Waits for what the thread is at, one kernel or one program, and lets it leave the rest.
  ~DevicePreparation();
  DevicePreparation(const DevicePreparation&) = delete;
  DevicePreparation& operator=(const DevicePreparation&) = delete;

  // Opens the device unless it is open, and has these kernels compiled. False where no thread can be started. Not while
  // is_getting_ready(). A thread that stores leaves that for later.
  bool start(const FrameKernels& kernels);
  // Begins to store what was compiled, if there is something. For when a frame was drawn with it: PoCL starts no kernel
  // for the first time while it makes a binary.
  void store();
  void wait_until_stored() const;  // and for all else that the thread is at
  void wait() const;               // until it is no longer getting ready

  bool is_getting_ready() const;  // opens or compiles
  bool is_compiling() const;
  bool is_working() const;                   // stores included
  std::shared_ptr<Session> session() const;  // null until it is open, or when it cannot be used
  std::string trouble() const;               // "" or why it cannot be used, in one line
  double opening_seconds() const;            // 0 until measured
  void give_up(const std::string& reason);   // the device failed: no frame is to be drawn by it any more

 private:
  bool run();
  void work();
  void get_ready();
  void open();
  void compile(const FrameKernels& kernels);

  Open open_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  // What follows is guarded by the mutex.
  std::shared_ptr<Session> session_;
  std::string trouble_;
  FrameKernels wanted_;
  double opening_seconds_ = 0;
  bool getting_ready_ = false, compiling_ = false, unstored_ = false, storing_wanted_ = false, working_ = false;
  std::atomic<bool> stop_ = false;          // for good
  std::atomic<bool> stop_storing_ = false;  // until the kernels that are wanted now are compiled
  std::thread thread_;
};

}  // namespace morphcl
