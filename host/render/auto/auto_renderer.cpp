#include <time.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "host/device/cache_dir.hpp"
#include "host/device/known_kernels.hpp"
#include "host/device/session_access.hpp"
#include "host/memory_room.hpp"
#include "host/render/auto/auto_settings.hpp"
#include "host/render/auto/device_preparation.hpp"
#include "host/render/auto/first_situation.hpp"
#include "host/render/auto/frame_estimate.hpp"
#include "host/render/auto/frame_kernels.hpp"
#include "host/thread_count.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// What a driver takes at most of the memory that is left: it is there for frames.
constexpr std::uint64_t driver_share = 4;

// How many times as long as storing its kernels a job is that stores them before its end.
constexpr double long_job = 8;

// A machine that gives less to this process is too busy to tell anything from.
constexpr double min_share = 0.2;

// A thread that has compiled kernels so often, and they are missing nonetheless, is not started again.
constexpr int max_starts = 3;

// Thrown by the device renderer's first look at a kernel that would have to be compiled.
struct KernelMissing {
  FrameKernel kernel;
};

// The least of the last few: what others have the machine do meanwhile only adds to it.
class Recent {
 public:
  explicit Recent(std::size_t needed) : needed_(needed) {}
  void add(double value) {
    last_[count_ % last_.size()] = value;
    ++count_;
  }
  bool is_known() const { return count_ >= needed_; }
  double value_or(double other) const {
    if (!is_known()) return other;
    return *std::min_element(last_.begin(),
                             last_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, last_.size())));
  }

 private:
  std::array<double, 8> last_ = {};
  std::size_t needed_, count_ = 0;
};

SessionOptions session_options(const AutoOptions& options) {
  SessionOptions session;
  session.threads = options.threads;
  session.cache_dir = options.cache_dir;
  return session;
}

class Turns : public AutoRenderer {
 public:
  explicit Turns(const AutoSettings& settings)
      : settings_(settings),
        threads_(choose_thread_count(settings.options.threads)),
        reference_(make_reference_renderer(reference_threads_)),
        preparation_([settings] { return settings.open(session_options(settings.options)); }) {
    if (memory_room().bytes / driver_share < driver_memory)
      preparation_.give_up("the memory that is left is too little for an OpenCL driver");
  }

  std::string name() const override { return "auto"; }
  std::string drawn_by() const override { return drawn_by_; }
  void expect_frames(std::int64_t count) override { expected_ = count; }
  Memory memory() const override {
    Memory memory = reference_->memory();
    if (preparation_.trouble().empty()) memory.fixed += driver_memory;
    return memory;
  }
  std::string note() const override { return preparation_.trouble(); }
  std::string device_name() const override {
    const std::shared_ptr<Session> session = preparation_.session();
    return session ? session->info().name : "";
  }
  void store_programs() override {
    if (preparation_.is_getting_ready() || drawn_on_device_ == 0) return;
    preparation_.store();
    preparation_.wait_until_stored();
  }
  bool is_compiling() const override { return preparation_.is_compiling(); }
  bool is_preparing() const override { return preparation_.is_working(); }
  std::string cache_trouble() const override {
    if (preparation_.is_getting_ready()) return "";  // the session is asked by nobody while it compiles: it would wait
    const std::shared_ptr<Session> session = preparation_.session();
    return session ? session->cache_trouble() : "";
  }

 private:
  static constexpr std::uint64_t driver_memory = std::uint64_t{110} << 20;  // as the device renderer has it

  void draw(const FramePlan& plan, FrameBuffer& frame) override {
    if (plan.visibility != VisibilityMethod::z_buffer)
      draw_by_reference(plan, frame);
    else
      while (!draw_as_chosen(plan, frame)) {
      }
    ++drawn_;
    if (expected_) expected_ = std::max<std::int64_t>(*expected_ - 1, 0);
  }

  // False when the frame is not drawn yet, and there is more to choose from, or less.
  bool draw_as_chosen(const FramePlan& plan, FrameBuffer& frame) {
    const FrameKernels needed = needed_by(plan);
    const Situation now = situation(plan, missing_of(needed));
    const Choice choice = settings_.choose(now);
    if (now.device == DeviceState::ready && choice != Choice::reference) return draw_on_device(plan, frame);
    if (now.device == DeviceState::closed && (choice == Choice::prepare || choice == Choice::wait)) start(needed);
    if (now.device != DeviceState::out && choice == Choice::wait) {
      preparation_.wait();
      return false;
    }
    draw_by_reference(plan, frame);
    return true;
  }

  DeviceState state(const FrameKernels& kernels) const {
    if (preparation_.is_getting_ready()) return DeviceState::preparing;
    if (!preparation_.trouble().empty()) return DeviceState::out;
    return preparation_.session() && kernels.empty() ? DeviceState::ready : DeviceState::closed;
  }

  // What the device draws this plan with, as far as is known.
  FrameKernels needed_by(const FramePlan& plan) const {
    FrameKernels needed = frame_kernels(plan);
    needed.insert(found_missing_.begin(), found_missing_.end());
    return needed;
  }

  // What of it has to be compiled. Before the device is open: all kernels.
  FrameKernels missing_of(const FrameKernels& needed) const {
    const std::shared_ptr<Session> session = preparation_.session();
    if (preparation_.is_getting_ready() || !session) return needed;
    FrameKernels missing;
    for (const FrameKernel& kernel : needed)
      if (!is_compiled(*session, kernel_source(kernel.stage), kernel.name, kernel.options)) missing.insert(kernel);
    return missing;
  }

  Situation situation(const FramePlan& plan, const FrameKernels& kernels) {
    Situation now;
    now.device = state(kernels);
    now.frames_drawn = drawn_;
    now.frames_left = expected_.value_or(std::max<std::int64_t>(drawn_, 1));
    now.threads = threads_;
    now.reference_frame = reference_seconds_.value_or(estimated_reference_seconds(plan, threads_));
    now.device_frame = device_seconds_.value_or(estimated_device_seconds(now.reference_frame));
    now.both_measured = reference_seconds_.is_known() && device_seconds_.is_known();
    if (now.device != DeviceState::closed) return now;
    if (!preparation_.session()) {
      if (!known_) known_.emplace(choose_cache_dir(settings_.options.cache_dir));
      set_preparation(kernels, *known_, now);
    } else {
      now.compiles = true;
      now.preparing = compile_seconds(kernels);
      now.storing = store_seconds(kernels);
    }
    // What was measured has other programs in it.
    now.preparing /= processor_share_;
    now.storing /= processor_share_;
    return now;
  }

  // What sets variables of the environment comes before there is another thread of the driver's.
  void start(const FrameKernels& kernels) {
    try {
      starts_ = kernels == started_for_ ? starts_ + 1 : 1;
      started_for_ = kernels;
      if (starts_ > max_starts) throw Error(ErrorKind::internal, "", "the kernels that the device needs do not come");
      if (!preparation_.session()) {
        prepare_process(settings_.options.threads);
        place_pocl_cache(choose_cache_dir(settings_.options.cache_dir));
      }
      preparation_.start(kernels);
    } catch (const std::exception& error) {
      preparation_.give_up(error.what());
    }
  }

  void draw_by_reference(const FramePlan& plan, FrameBuffer& frame) {
    // The thread beside the frames keeps a processor to itself, so that it is done soon.
    const bool beside = preparation_.is_working();
    if (const int threads = beside ? std::max(threads_ - 1, 1) : threads_; threads != reference_threads_) {
      reference_.reset();  // with its memory
      reference_ = make_reference_renderer(threads);
      reference_threads_ = threads;
    }
    const double processors_before = processor_seconds();
    const double seconds = timed([&] { draw_by(*reference_, plan, frame); });
    const double threads = threads_;
    if (seconds > 0)
      processor_share_ = std::clamp((processor_seconds() - processors_before) / (seconds * threads), min_share, 1.0);
    reference_seconds_.add(!beside ? seconds : threads_ > 1 ? seconds * (threads - 1) / threads : seconds / 2);
    drawn_by_ = reference_->name();
  }

  bool draw_on_device(const FramePlan& plan, FrameBuffer& frame) {
    try {
      const std::shared_ptr<Session> session = preparation_.session();
      if (!device_)
        device_ = make_device_renderer(session, [session](const FrameKernel& kernel) {
          if (!is_compiled(*session, kernel_source(kernel.stage), kernel.name, kernel.options))
            throw KernelMissing{kernel};
        });
      const bool beside = preparation_.is_working();
      const double seconds = timed([&] { draw_by(*device_, plan, frame); });
      // The first one brings the meshes to the device; and what is stored beside the frames is stored soon.
      if (drawn_on_device_++ > 0 && !beside) device_seconds_.add(seconds);
      drawn_by_ = device_->name();
      store_in_a_long_job(plan);
      return true;
    } catch (const KernelMissing& missing) {
      found_missing_.insert(missing.kernel);
    } catch (const std::exception& error) {
      preparation_.give_up(error.what());
    }
    return false;
  }

  // PoCL starts no kernels while it makes binaries. A job that lasts long may be ended at any time by others.
  void store_in_a_long_job(const FramePlan& plan) {
    if (!device_seconds_.is_known()) return;  // the first frames take more, of what is done once
    const auto left = static_cast<double>(expected_.value_or(drawn_));
    if (left * device_seconds_.value_or(0) > long_job * store_seconds(frame_kernels(plan))) preparation_.store();
  }

  template <class Work>
  static double timed(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  // Of all threads of this process.
  static double processor_seconds() {
    timespec time = {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  AutoSettings settings_;
  int threads_;
  int reference_threads_ = threads_;
  std::unique_ptr<Renderer> reference_, device_;
  DevicePreparation preparation_;
  std::optional<KnownKernels> known_;
  FrameKernels found_missing_;  // that frame_kernels() did not know of
  FrameKernels started_for_;
  int starts_ = 0;  // for the same kernels, one after the other
  std::string drawn_by_ = "auto";
  std::int64_t drawn_ = 0, drawn_on_device_ = 0;
  std::optional<std::int64_t> expected_;
  Recent reference_seconds_{1}, device_seconds_{4};
  double processor_share_ = 1;  // of threads_ processors, that the reference had for its last frame
};

}  // namespace

std::unique_ptr<AutoRenderer> make_auto_renderer(const AutoSettings& settings) {
  return std::make_unique<Turns>(settings);
}

std::unique_ptr<AutoRenderer> make_auto_renderer(const AutoOptions& options) {
  return make_auto_renderer(AutoSettings{.options = options});
}

}  // namespace morphcl
