#include "host/job/render_job.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>

#include "host/job/frame_output.hpp"
#include "host/job/write_queue.hpp"
#include "host/render/plan.hpp"

namespace morphcl {

namespace {

constexpr int most_threads = 8;
constexpr std::size_t most_memory = std::size_t{2} << 30;

int thread_count(const RenderJob& job) {
  const int wanted = job.threads > 0 ? job.threads : static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(wanted, 1, most_threads);
}

int buffer_count(const RenderJob& job, const ImageSettings& image) {
  if (job.frames_in_flight > 0) return job.frames_in_flight;
  const std::size_t pixel_bytes = (image.color ? 4 * sizeof(std::uint16_t) : 0) + (image.depth ? sizeof(float) : 0);
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const std::size_t fitting = most_memory / std::max<std::size_t>(1, pixels * pixel_bytes);
  return static_cast<int>(std::clamp<std::size_t>(fitting, 2, static_cast<std::size_t>(thread_count(job)) + 1));
}

// One run of a job: what its steps share.
class JobRun {
 public:
  JobRun(const RenderJob& job, const Scene& scene, Renderer& renderer)
      : job_(job), scene_(scene), renderer_(renderer), output_(job, scene.image) {}

  JobResult run() {
    const std::vector<std::int64_t> missing = job_.resume ? keep_finished_frames() : job_.frames;
    render(missing);
    std::sort(result_.frames.begin(), result_.frames.end(),
              [](const FrameResult& a, const FrameResult& b) { return a.frame < b.frame; });
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

  std::vector<std::int64_t> keep_finished_frames();
  void render(const std::vector<std::int64_t>& frames);
  void render_frame(const Planner& planner, std::int64_t frame, WriteQueue& queue);

  const RenderJob& job_;
  const Scene& scene_;
  Renderer& renderer_;
  FrameOutput output_;
  std::mutex report_mutex_;
  JobResult result_;
};

// Reports the frames that stand already and returns the others, in the job's order. Decoding takes as long as writing,
// so all threads share it.
std::vector<std::int64_t> JobRun::keep_finished_frames() {
  std::vector<char> kept(job_.frames.size(), 0);
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  const auto check_frames = [&] {
    try {
      for (std::size_t i; !stopped() && (i = next++) < job_.frames.size();)
        if (const auto result = output_.keep(job_.frames[i])) {
          kept[i] = 1;
          report(*result);
        }
    } catch (...) {
      const std::lock_guard lock(report_mutex_);
      if (!failure) failure = std::current_exception();
      next = job_.frames.size();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < thread_count(job_); ++i) threads.emplace_back(check_frames);
  }
  if (failure) std::rethrow_exception(failure);
  std::vector<std::int64_t> missing;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (!kept[i]) missing.push_back(job_.frames[i]);
  return missing;
}

void JobRun::render(const std::vector<std::int64_t>& frames) {
  if (frames.empty()) return;
  const ImageSettings& image = scene_.image;
  const Planner planner(scene_, job_.plan);
  // Frames side by side keep all threads busy; a single one needs them all.
  const int exr_threads = frames.size() == 1 ? thread_count(job_) : 1;
  WriteQueue queue(
      buffer_count(job_, image), thread_count(job_),
      [&image] { return std::make_unique<FrameBuffer>(image.width, image.height, image.color, image.depth); },
      [this, exr_threads](DrawnFrame& frame) {
        output_.write(*frame.pixels, frame.attributes, frame.result, exr_threads);
        report(frame.result);
      });
  for (const std::int64_t frame : frames) {
    if (stopped()) result_.interrupted = true;
    if (result_.interrupted || queue.broken()) break;
    render_frame(planner, frame, queue);
  }
  queue.finish();
}

void JobRun::render_frame(const Planner& planner, std::int64_t frame, WriteQueue& queue) {
  DrawnFrame drawn;
  drawn.result.frame = frame;
  drawn.result.path = output_.path(frame);
  drawn.pixels = queue.take_buffer();
  try {
    const FramePlan plan = planner.plan(frame);
    const auto start = std::chrono::steady_clock::now();
    renderer_.render(plan, *drawn.pixels);
    drawn.result.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    drawn.attributes = {frame,
                        scene_.timeline.time.fps_numerator,
                        scene_.timeline.time.fps_denominator,
                        plan.world_to_eye,
                        plan.world_to_ndc,
                        job_.fingerprint};
  } catch (const std::exception& error) {
    queue.give_back(std::move(drawn.pixels));
    set_failed(drawn.result, error);
    report(drawn.result);
    return;
  }
  queue.put(std::move(drawn));
}

}  // namespace

JobResult run(const RenderJob& job, const Scene& scene, Renderer& renderer) {
  return JobRun(job, scene, renderer).run();
}

}  // namespace morphcl
