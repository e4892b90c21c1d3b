#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <unordered_set>
#include <utility>

#include "host/job/equal_frames.hpp"
#include "host/job/frame_output.hpp"
#include "host/job/job_memory.hpp"
#include "host/job/plan_ahead.hpp"
#include "host/job/write_queue.hpp"
#include "host/memory_room.hpp"
#include "host/threads.hpp"
#include "morphcl/job.hpp"

namespace morphcl {

namespace {

constexpr int max_threads = 8;

int thread_count(const RenderJob& job) {
  const int wanted = job.threads > 0 ? job.threads : static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(wanted, 1, max_threads);
}

// One run of a job: what its steps share.
class JobRun {
 public:
  JobRun(const RenderJob& job, const Scene& scene, Renderer& renderer)
      : job_(job),
        planner_(scene, job.plan),
        renderer_(renderer),
        limits_(job_limits(job, scene.image, renderer.memory(), thread_count(job), memory_room().bytes)),
        output_(job, scene, renderer.deviation(), thread_count(job)) {
    renderer.forget();
  }
  ~JobRun() { renderer_.forget(); }  // no other plan of this planner comes
  JobRun(const JobRun&) = delete;
  JobRun& operator=(const JobRun&) = delete;

  JobResult run() {
    const std::vector<std::int64_t> missing = job_.resume ? keep_finished_frames() : job_.frames;
    render(missing);
    std::sort(result_.frames.begin(), result_.frames.end(),
              [](const FrameResult& a, const FrameResult& b) { return a.frame < b.frame; });
    output_.find_lost(result_.frames);
    output_.finish();
    return std::move(result_);
  }

 private:
  bool stopped() const { return job_.stop && job_.stop->load(); }

  void report(const FrameResult& result) {
    const std::lock_guard lock(report_mutex_);
    result_.frames.push_back(result);
    if (job_.on_frame) job_.on_frame(result);
  }

  void report_checked(std::int64_t frame) {
    const std::lock_guard lock(report_mutex_);
    if (job_.on_checked) job_.on_checked(frame);
  }

  std::vector<std::int64_t> keep_finished_frames();
  void render(const std::vector<std::int64_t>& frames);
  void add_frame(PlannedFrame& planned, WriteQueue& queue);
  void draw_frame(PlannedFrame& planned, WrittenFramePromise written, WriteQueue& queue);
  FrameTask task_for(const PlannedFrame& planned) const;
  void write(FrameTask& task, int encoding_threads, const WriteQueue::ReleasePixels& release);
  bool copy(FrameTask& task);
  void draw_lost_copies(WriteQueue& queue);

  const RenderJob& job_;
  const Planner planner_;
  Renderer& renderer_;
  const JobLimits limits_;
  FrameOutput output_;
  EqualFrames equal_frames_;
  std::mutex report_mutex_, lost_mutex_;
  std::vector<std::pair<std::int64_t, PlanDigest>> lost_copies_;  // frames whose source could not be read
  std::unordered_set<std::int64_t> useless_files_;                // frames that had a file which was not kept
  JobResult result_;
};

// Reports the frames that stand already and returns the others, in the job's order. Decoding takes as long as writing,
// so all threads share it.
std::vector<std::int64_t> JobRun::keep_finished_frames() {
  enum class FrameState : char { missing, useless, kept };
  std::vector<FrameState> states(job_.frames.size(), FrameState::missing);
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  const auto check_frame = [&](std::size_t i) {
    const std::int64_t frame = job_.frames[i];
    const auto result = output_.keep(frame);
    if (result)
      states[i] = FrameState::kept;
    else if (output_.exists(frame))
      states[i] = FrameState::useless;
    report_checked(frame);
    if (result) report(*result);
  };
  const auto check_frames = [&] {
    try {
      for (std::size_t i; !stopped() && (i = next++) < job_.frames.size();) check_frame(i);
    } catch (...) {
      const std::lock_guard lock(report_mutex_);
      if (!failure) failure = std::current_exception();
      next = job_.frames.size();
    }
  };
  {
    std::vector<std::jthread> threads;
    start_threads(threads, limits_.checkers - 1, [&check_frames](int) { check_frames(); });
    check_frames();
  }
  if (failure) std::rethrow_exception(failure);
  std::vector<std::int64_t> missing;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] != FrameState::kept) missing.push_back(job_.frames[i]);
    if (states[i] == FrameState::useless) useless_files_.insert(job_.frames[i]);
  }
  return missing;
}

void JobRun::render(const std::vector<std::int64_t>& frames) {
  if (frames.empty()) return;
  const ImageSettings& image = planner_.scene().image;
  // Frames side by side keep all threads busy; a single one needs them all.
  const int encoding_threads = frames.size() == 1 ? thread_count(job_) : 1;
  WriteQueue queue(
      limits_.queue, [&image] { return std::make_unique<FrameBuffer>(image.width, image.height, image.channels); },
      [this, encoding_threads](FrameTask& task, const WriteQueue::ReleasePixels& release) {
        write(task, encoding_threads, release);
      });
  const auto going_on = [&] {
    if (stopped()) result_.interrupted = true;
    return !result_.interrupted && !queue.broken();
  };
  PlanAhead plans(planner_, frames);
  for (std::size_t i = 0; i < frames.size() && going_on(); ++i) {
    PlannedFrame planned = plans.next();
    renderer_.expect_frames(static_cast<std::int64_t>(frames.size() - i));
    add_frame(planned, queue);
    draw_lost_copies(queue);
  }
  queue.drain();
  draw_lost_copies(queue);
  queue.finish();
}

// Queues the frame as a copy where that is possible, else draws it.
void JobRun::add_frame(PlannedFrame& planned, WriteQueue& queue) {
  if (planned.failure || !job_.reuse_equal_frames) return draw_frame(planned, {}, queue);
  auto source = equal_frames_.find_or_claim(planned.digest);
  if (auto* const claimed = std::get_if<WrittenFramePromise>(&source))
    return draw_frame(planned, std::move(*claimed), queue);
  FrameTask copy = task_for(planned);
  copy.result.status = FrameResult::Status::copied;
  copy.source = std::get<WrittenFrameFuture>(source);
  queue.put(std::move(copy));
}

void JobRun::draw_frame(PlannedFrame& planned, WrittenFramePromise written, WriteQueue& queue) {
  FrameTask task = task_for(planned);
  task.written = std::move(written);
  task.pixels = queue.take_buffer();
  try {
    if (planned.failure) std::rethrow_exception(planned.failure);
    const auto start = std::chrono::steady_clock::now();
    renderer_.render(*planned.plan, *task.pixels);
    task.result.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    task.result.drawn_by = renderer_.drawn_by();
    if (job_.on_drawn) job_.on_drawn(planned.frame);
  } catch (const std::exception& error) {
    queue.give_back(std::move(task.pixels));
    set_failed(task.result, error);
    report(task.result);
    return;
  }
  queue.put(std::move(task));
}

FrameTask JobRun::task_for(const PlannedFrame& planned) const {
  FrameTask task;
  task.result.frame = planned.frame;
  task.result.path = output_.path(planned.frame);
  task.result.replaced = useless_files_.count(planned.frame) != 0;
  if (planned.plan) task.attributes = planned.plan->attributes();
  task.attributes.fingerprint = output_.fingerprint();
  task.attributes.deviation = renderer_.deviation();
  const ImageSettings& image = planner_.scene().image;
  task.attributes.z_error = image.z_error;
  task.attributes.p_error = image.p_error;
  task.attributes.n_error = image.n_error;
  task.picture = planned.digest;
  return task;
}

// By the queue's threads.
void JobRun::write(FrameTask& task, int encoding_threads, const WriteQueue::ReleasePixels& release) {
  if (task.pixels) {
    task.written.set_value(output_.write(*task.pixels, task.attributes, task.result, encoding_threads, release));
  } else if (!copy(task)) {
    const std::lock_guard lock(lost_mutex_);
    lost_copies_.emplace_back(task.result.frame, task.picture);
    return;
  }
  report(task.result);
}

// The source stands before the copy in the queue, so it has been written or is being written by another thread.
bool JobRun::copy(FrameTask& task) {
  try {
    return output_.copy(task.source.get(), task.attributes, task.result);
  } catch (const std::future_error&) {
    return false;  // the source was given up
  }
}

// Frames that were to be copied from a file that has failed or gone.
void JobRun::draw_lost_copies(WriteQueue& queue) {
  std::vector<std::pair<std::int64_t, PlanDigest>> lost;
  {
    const std::lock_guard lock(lost_mutex_);
    lost.swap(lost_copies_);
  }
  for (const auto& [frame, picture] : lost) {
    equal_frames_.forget(picture);
    PlannedFrame planned = plan_with_digest(planner_, frame);
    draw_frame(planned, {}, queue);
  }
}

}  // namespace

JobResult run(const RenderJob& job, const Scene& scene, Renderer& renderer) {
  if (!job.frames.empty() || scene.frames.empty()) return JobRun(job, scene, renderer).run();
  RenderJob all = job;
  all.frames = frame_numbers(scene.frames);
  return JobRun(all, scene, renderer).run();
}

}  // namespace morphcl
