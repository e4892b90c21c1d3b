#include "host/render/auto/device_preparation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "host/device/session_access.hpp"

namespace morphcl {

namespace {

// Ends a sample's drawing where the thread is to stop.
struct Stopped {};

}  // namespace

DevicePreparation::~DevicePreparation() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    stop_storing_ = true;
  }
  if (thread_.joinable()) thread_.join();
}

bool DevicePreparation::start(const FrameKernels& kernels) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = kernels;
    getting_ready_ = true;
    stop_storing_ = working_;
  }
  return run();
}

void DevicePreparation::store() {
  {
    const std::lock_guard lock(mutex_);
    if (!unstored_) return;
    unstored_ = false;
    storing_wanted_ = true;
  }
  run();
}

bool DevicePreparation::run() {
  {
    const std::lock_guard lock(mutex_);
    if (working_) return true;
  }
  if (thread_.joinable()) thread_.join();
  const std::lock_guard lock(mutex_);
  try {
    working_ = true;
    thread_ = std::thread([this] { work(); });
    return true;
  } catch (const std::system_error& error) {
    working_ = getting_ready_ = storing_wanted_ = false;
    trouble_ = fmt::format("no thread can be started to open the device: {}", error.code().message());
    return false;
  }
}

void DevicePreparation::wait() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !getting_ready_; });
}

void DevicePreparation::wait_until_stored() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !working_; });
}

void DevicePreparation::work() {
  for (;;) {
    bool getting_ready = false;
    {
      const std::lock_guard lock(mutex_);
      working_ = !stop_ && (getting_ready_ || storing_wanted_);
      if (!working_) {
        getting_ready_ = false;
        changed_.notify_all();
        return;
      }
      getting_ready = getting_ready_;
      stop_storing_ = false;
      if (!getting_ready) storing_wanted_ = false;
    }
    if (getting_ready)
      get_ready();
    else if (const std::shared_ptr<Session> opened = session())
      store_programs(*opened, stop_storing_);
  }
}

void DevicePreparation::get_ready() {
  std::string trouble;
  try {
    open();
    FrameKernels kernels;
    {
      const std::lock_guard lock(mutex_);
      kernels = wanted_;
    }
    if (session()) compile(kernels);
  } catch (const Stopped&) {
    // Nobody waits for what is left.
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  const std::lock_guard lock(mutex_);
  if (!trouble.empty()) trouble_ = trouble;
  getting_ready_ = compiling_ = false;
  changed_.notify_all();
}

void DevicePreparation::open() {
  if (session()) return;
  const auto start = std::chrono::steady_clock::now();
  std::shared_ptr<Session> opened = open_();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const std::lock_guard lock(mutex_);
  opening_seconds_ = seconds.count();
  if (opened->verdict() == Verdict::identical)
    session_ = std::move(opened);
  else
    trouble_ = fmt::format("device \"{}\" rounds differently ({})", opened->info().name, opened->verdict_detail());
}

void DevicePreparation::compile(const FrameKernels& kernels) {
  const std::shared_ptr<Session> opened = session();
  const auto is_missing = [&](const FrameKernel& kernel) {
    return !is_compiled(*opened, kernel_source(kernel.stage), kernel.name, kernel.options);
  };
  const auto renderer = make_device_renderer(opened, [&](const FrameKernel& kernel) {
    if (stop_) throw Stopped();
    if (!is_missing(kernel)) return;
    const std::lock_guard lock(mutex_);
    compiling_ = true;
  });
  if (std::none_of(kernels.begin(), kernels.end(), is_missing)) return;
  {
    const std::lock_guard lock(mutex_);
    unstored_ = true;
  }
  // Of all of them: a stage is started with the kernels that it comes with in this frame, and with no others.
  const KernelSamples samples(kernels);
  for (const FramePlan& plan : samples.plans()) {
    const Plan sample(plan);
    FrameBuffer frame = sample.make_frame();
    renderer->render(sample, frame);
  }
}

bool DevicePreparation::is_getting_ready() const {
  const std::lock_guard lock(mutex_);
  return getting_ready_;
}

bool DevicePreparation::is_compiling() const {
  const std::lock_guard lock(mutex_);
  return compiling_;
}

bool DevicePreparation::is_working() const {
  const std::lock_guard lock(mutex_);
  return working_;
}

std::shared_ptr<Session> DevicePreparation::session() const {
  const std::lock_guard lock(mutex_);
  return trouble_.empty() ? session_ : nullptr;
}

std::string DevicePreparation::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

double DevicePreparation::opening_seconds() const {
  const std::lock_guard lock(mutex_);
  return opening_seconds_;
}

void DevicePreparation::give_up(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  trouble_ = reason;
}

}  // namespace morphcl
