// morphcl_bench_plan SUBJECT...: what each item that a plan leaves out saves. A subject is a shot file or a scene of
// the benchmarks.
//
// A frame is planned and rendered with the item left out and with it done, everything else left out in both; the runs
// of all variants follow each other in turn, round after round, each on a renderer and a picture of its own, so that
// what one keeps from frame to frame is its own. A round's figure is the mean over the frames after the first two; the
// table has the medians over the rounds. Prints CSV: subject, item, ms left out, ms done.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <unordered_set>

#include "bench/morphcl_scene.hpp"
#include "bench/rig_scene.hpp"
#include "host/device/session.hpp"
#include "host/error.hpp"
#include "host/render/device_renderer.hpp"
#include "host/render/plan_digest.hpp"
#include "host/scene/load_scene.hpp"

namespace morphcl::bench {

namespace {

constexpr int first_timed_frame = 2;

struct Settings {
  std::vector<std::string> subjects;
  int rounds = 9, frames = 24, threads = 0;
};

Scene make_subject(const std::string& name, int frames) {
  if (name == "rig") return rig_scene(256, 0, 0, frames);
  const std::vector<std::string>& known = scene_names();
  if (std::find(known.begin(), known.end(), name) == known.end()) return load_scene(name, {});
  BenchScene bench = make_bench_scene(name, 0, 0, 0);
  return morphcl_scene(bench, frames);
}

// One way to draw the subject, with what it keeps from frame to frame.
struct Variant {
  Variant(std::string item_, const Scene& subject, const PlanOptions& options, const std::shared_ptr<Session>& session,
          const std::function<void(ImageSettings&)>& change = {})
      : item(std::move(item_)), scene(subject) {
    if (change) change(scene.image);
    planner = std::make_unique<Planner>(scene, options);
    renderer = make_device_renderer(session);
    pixels = std::make_unique<FrameBuffer>(scene.image.width, scene.image.height, scene.image.color, scene.image.depth);
  }

  // Draws the frames and remembers what one of them took on average.
  void run(const std::vector<std::int64_t>& frames, bool skips_equal) {
    std::unordered_set<PlanDigest> drawn;
    std::chrono::steady_clock::duration total{};
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      const FramePlan plan = planner->plan(frames[i]);
      if (!skips_equal || drawn.insert(pixel_digest(plan)).second) renderer->render(plan, *pixels);
      if (i >= first_timed_frame) total += std::chrono::steady_clock::now() - start;
    }
    rounds.push_back(std::chrono::duration<double, std::milli>(total).count() /
                     static_cast<double>(frames.size() - first_timed_frame));
  }
  double median() {
    std::sort(rounds.begin(), rounds.end());
    return rounds[rounds.size() / 2];
  }

  std::string item;
  Scene scene;
  std::unique_ptr<Planner> planner;
  std::unique_ptr<Renderer> renderer;
  std::unique_ptr<FrameBuffer> pixels;
  std::vector<double> rounds;
};

std::deque<Variant> make_variants(const Scene& scene, const std::shared_ptr<Session>& session) {
  std::deque<Variant> variants;  // which stay where they are, as planners refer to their scenes
  const auto add = [&](const char* item, const PlanOptions& options,
                       const std::function<void(ImageSettings&)>& change = {}) {
    variants.emplace_back(item, scene, options, session, change);
  };
  add("", {});
  add("objects out of view", {.objects_out_of_view = false});
  add("idle morph targets", {.idle_targets = false});
  add("normals and light", {.normals = false});
  add("clipping", {.clipping = false});
  add("perspective divide", {.divide = false});
  add("depth test", {.depth_test = false});
  add("unchanged objects", {.kept_vertices = false});
  add("blank tiles", {.blank_tiles = false});
  if (!scene.image.color) add("RGBA", {}, [](ImageSettings& image) { image.color = true; });
  if (!scene.image.depth) add("Z", {}, [](ImageSettings& image) { image.depth = true; });
  add("all of these", {.leave_out = false});
  add("equal frames", {});
  return variants;
}

void measure(const std::string& name, const Settings& settings, const std::shared_ptr<Session>& session) {
  const Scene scene = make_subject(name, settings.frames);
  std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  while (frames.size() <= first_timed_frame) frames.push_back(frames.back());
  if (frames.size() > static_cast<std::size_t>(settings.frames)) frames.resize(settings.frames);
  std::deque<Variant> variants = make_variants(scene, session);
  for (int round = 0; round < settings.rounds; ++round)
    for (Variant& variant : variants) variant.run(frames, variant.item == "equal frames");
  const double usual = variants[0].median();
  for (std::size_t i = 1; i < variants.size(); ++i) {
    const double other = variants[i].median();
    const bool skips = variants[i].item == "equal frames";
    fmt::print("{},{},{:.4f},{:.4f}\n", name, variants[i].item, skips ? other : usual, skips ? usual : other);
  }
}

void run(const Settings& settings) {
  SessionOptions options;
  options.threads = prepare_process(settings.threads);
  const std::shared_ptr<Session> session = Session::open(options);
  fmt::print("subject,item,left_out_ms,done_ms\n");
  for (const std::string& subject : settings.subjects) measure(subject, settings, session);
  session->store_programs();
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  using namespace morphcl;
  bench::Settings settings;
  CLI::App app("What each item that a plan leaves out saves.");
  app.add_option("SUBJECT", settings.subjects, "shot files, or scenes of the benchmarks")->required();
  app.add_option("--rounds", settings.rounds, "of all variants")->check(CLI::Range(1, 10'000));
  app.add_option("--frames", settings.frames, "at most, of each run")->check(CLI::Range(3, 1'000'000));
  app.add_option("--threads", settings.threads, "that draw; default: what the process may use")
      ->check(CLI::Range(1, 4096));
  CLI11_PARSE(app, argc, argv);
  try {
    bench::run(settings);
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "morphcl_bench_plan: {}\n", error.what());
    return error.exit_code();
  }
}
