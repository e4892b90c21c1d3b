// morphcl_bench_plan SUBJECT...: what each item that a plan leaves out saves. A subject is a shot file or a scene of
// the benchmarks.
//
// A frame is planned and rendered with the item left out and with it done, everything else left out in both. Both ways
// run the frames in turn, round after round, and who is first changes; each has a renderer and a picture of its own, so
// that what one keeps from frame to frame is its own. A round's figures are the means over the frames after the first
// two. Prints CSV: subject, item, medians over the rounds in ms left out and done, and what is saved in percent of the
// frame with the item done: median, lowest and highest of the rounds.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <functional>
#include <unordered_set>

#include "bench/morphcl_scene.hpp"
#include "bench/rig_scene.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/plan_digest.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/session.hpp"

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
  Variant(const Scene& subject, const PlanOptions& options, const std::shared_ptr<Session>& session,
          const std::function<void(ImageSettings&)>& change = {})
      : scene(subject) {
    if (change) change(scene.image);
    planner = std::make_unique<Planner>(scene, options);
    renderer = make_device_renderer(session);
    pixels = std::make_unique<FrameBuffer>(scene.image.width, scene.image.height, scene.image.channels);
  }

  // Draws the frames; what one of them took on average, in milliseconds.
  double run(const std::vector<std::int64_t>& frames, bool skips_equal) {
    std::unordered_set<PlanDigest> drawn;
    std::chrono::steady_clock::duration total{};
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      const Plan plan = planner->plan(frames[i]);
      if (!skips_equal || drawn.insert(pixel_digest(*plan)).second) renderer->render(plan, *pixels);
      if (i >= first_timed_frame) total += std::chrono::steady_clock::now() - start;
    }
    return std::chrono::duration<double, std::milli>(total).count() /
           static_cast<double>(frames.size() - first_timed_frame);
  }
  Scene scene;
  std::unique_ptr<Planner> planner;
  std::unique_ptr<Renderer> renderer;
  std::unique_ptr<FrameBuffer> pixels;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// The two ways in turn: `lean` has the item left out.
void compare(const std::string& name, const std::string& item, const std::function<double()>& lean,
             const std::function<double()>& full, int rounds) {
  std::vector<double> left_out, done, saved;
  for (int round = -1; round < rounds; ++round) {
    double lean_ms = 0, full_ms = 0;
    if (round % 2 == 0) {
      lean_ms = lean();
      full_ms = full();
    } else {
      full_ms = full();
      lean_ms = lean();
    }
    if (round < 0) continue;  // warm-up
    left_out.push_back(lean_ms);
    done.push_back(full_ms);
    saved.push_back(100 * (1 - lean_ms / full_ms));
  }
  const auto [lowest, highest] = std::minmax_element(saved.begin(), saved.end());
  fmt::print("{},{},{:.4f},{:.4f},{:.1f},{:.1f},{:.1f}\n", name, item, median(left_out), median(done), median(saved),
             *lowest, *highest);
}

struct Item {
  const char* name;
  PlanOptions done;
  std::function<void(ImageSettings&)> change = {};
};

std::vector<Item> items(const ImageSettings& image) {
  std::vector<Item> list = {{"objects out of view", {.objects_out_of_view = false}},
                            {"idle morph targets", {.idle_targets = false}},
                            {"normals and light", {.normals = false}},
                            {"clipping", {.clipping = false}},
                            {"perspective divide", {.divide = false}},
                            {"depth test", {.depth_test = false}},
                            {"unchanged objects", {.kept_vertices = false}},
                            {"blank tiles", {.blank_tiles = false}},
                            {"all of these", {.leave_out = false}}};
  if (!image.has_color()) list.push_back({"RGBA", {}, [](ImageSettings& i) { i.channels.insert(Channel::color); }});
  if (!image.has_depth()) list.push_back({"Z", {}, [](ImageSettings& i) { i.channels.insert(Channel::depth); }});
  return list;
}

void measure(const std::string& name, const Settings& settings, const std::shared_ptr<Session>& session) {
  const Scene scene = make_subject(name, settings.frames);
  std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  while (frames.size() <= first_timed_frame) frames.push_back(frames.back());
  if (frames.size() > static_cast<std::size_t>(settings.frames)) frames.resize(settings.frames);
  Variant lean(scene, {}, session);
  const auto run_lean = [&] { return lean.run(frames, false); };
  for (const Item& item : items(scene.image)) {
    Variant full(scene, item.done, session, item.change);
    compare(name, item.name, run_lean, [&] { return full.run(frames, false); }, settings.rounds);
  }
  compare(name, "equal frames", [&] { return lean.run(frames, true); }, run_lean, settings.rounds);
}

void run(const Settings& settings) {
  SessionOptions options;
  options.threads = prepare_process(settings.threads);
  const std::shared_ptr<Session> session = Session::open(options);
  fmt::print("subject,item,left_out_ms,done_ms,saved_percent,lowest,highest\n");
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
