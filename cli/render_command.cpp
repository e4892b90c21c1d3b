#include "cli/render_command.hpp"

#include <fmt/core.h>

#include <future>
#include <optional>
#include <system_error>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/explain_method.hpp"
#include "cli/frames_in_work.hpp"
#include "cli/option_values.hpp"
#include "cli/render_report.hpp"
#include "cli/stop_signals.hpp"
#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::cli {

namespace {

// Beside the job where a thread can be started, else when its result is waited for.
std::future<void> start_storing_programs(const OpenedRenderer& opened) {
  return std::async(std::launch::async | std::launch::deferred, [&opened] { opened.store_programs(); });
}

// What does not go with the frames' format is refused, whatever the scene has.
void check_options_of_format(const RenderOptions& options, FrameFormat format) {
  const auto refuse = [](const char* option, const char* message) { throw Error(ErrorKind::usage, option, message); };
  if (format == FrameFormat::exr) {
    if (options.png_bits) refuse("--png-bits", "is of PNG frames, and these are EXR frames; end the output in .png");
    return;
  }
  if (options.scene.compression)
    refuse("--compression", "is of EXR frames, and these are PNG frames, which lose nothing by theirs; leave it out");
  if (options.scene.channel_names)
    refuse("--channel-names", "is of EXR frames, and PNG frames hold RGBA alone; leave it out");
  if (options.scene.z_error) refuse("--z-error", "is of Z in EXR frames, and PNG frames have none; leave it out");
  if (options.scene.p_error) refuse("--p-error", "is of P in EXR frames, and PNG frames have none; leave it out");
  if (options.scene.n_error) refuse("--n-error", "is of N in EXR frames, and PNG frames have none; leave it out");
  if (options.preview) refuse("--preview", "is a PNG beside each EXR frame, and these are PNG frames; leave it out");
  ImageSettings asked;
  if (options.scene.channels) set_channels(*options.scene.channels, asked);
  if (options.scene.channels && !(asked.channels - ChannelSet{Channel::color}).empty())
    refuse("--channels", "PNG frames hold RGBA alone; --channels RGBA, or an output that ends in .exr");
}

// Devices draw by z-buffer; other methods leave nothing to choose from.
DeviceOptions device_of_method(const DeviceOptions& asked, VisibilityMethod method) {
  if (method == VisibilityMethod::z_buffer || asked.device == reference_name) return asked;
  if (asked.device != auto_name)
    throw Error(ErrorKind::usage, "--device",
                fmt::format("a device draws by z-buffer; visibility {} is the reference renderer's: --device {}, or "
                            "--visibility z-buffer",
                            name_of(method), reference_name));
  return {.device = reference_name, .threads = asked.threads};
}

}  // namespace

int render_command(const RenderOptions& options) {
  FramesInWork in_work;
  std::atomic<std::size_t> total = 0;
  std::optional<StopPlanScope> stop_plan(
      std::in_place,
      StopPlan{[&in_work] { return in_work.none(); }, [&] { return interrupted_words(in_work.whole(), total); }});
  std::optional<std::vector<FrameRange>>
      ranges;  // read first, so that a wrong one is reported before a large file is read
  if (options.frames) ranges = parse_frame_range(*options.frames);
  const FrameFormat format = options.pattern ? frame_format(*options.pattern) : FrameFormat::exr;
  check_options_of_format(options, format);
  const int png_bits = options.png_bits ? parse_png_bits(*options.png_bits) : 8;
  const double exposure_stops = options.exposure ? parse_exposure(*options.exposure) : 0;

  Scene scene = open_scene(options.scene);
  // What else a shot has for its EXR frames. Of a shot without colour run() says that no PNG can be made.
  if (format == FrameFormat::png && scene.image.has_color()) {
    scene.image.channels = {Channel::color};
    scene.image.channel_names = ChannelNames::plain;
    scene.image.z_error = scene.image.p_error = scene.image.n_error = 0;
  }
  if (ranges) scene.frames = *ranges;
  print_warnings(scene);

  RenderJob job;
  job.pattern = options.pattern.value_or(scene.name + ".####.exr");
  job.frames = frame_numbers(scene.frames);
  job.sample_bits = png_bits;
  job.exposure_stops = exposure_stops;
  job.resume = options.resume;
  job.verify = options.verify;
  job.plan.leave_out = options.leave_out;
  job.reuse_equal_frames = options.leave_out;
  job.contact_sheet = options.contact_sheet;
  job.preview = options.preview;
  job.stop = &stop_requested();
  total = job.frames.size();

  const OpenedRenderer opened = open_renderer(device_of_method(options.device, scene.image.visibility));
  job.threads = opened.threads;
  RenderReport::Settings settings;
  settings.device = opened.device_name;
  if (!options.contact_sheet.empty()) settings.extra_outputs.push_back(options.contact_sheet);
  settings.json = options.json;
  settings.quiet = options.quiet;
  settings.checks_first = options.resume;
  if (opened.session) settings.kernels_compiled = [&opened] { return opened.session->kernels_compiled(); };
  RenderReport report(job.frames.size(), settings);
  std::future<void> programs_stored;  // from the first frame on, as a driver may take as long as for compiling them
  job.on_checked = [&report](std::int64_t) { report.checked(); };
  job.on_drawn = [&](std::int64_t frame) {
    in_work.drawn(frame);
    report.drawn();
  };
  job.on_frame = [&](const FrameResult& result) {
    report.frame(result);
    in_work.reported(result);
    if (opened.session && result.status == FrameResult::Status::rendered && !programs_stored.valid())
      programs_stored = start_storing_programs(opened);
  };
  const JobResult result = run(job, scene, *opened.renderer);
  stop_plan.reset();  // what there is to say of an interruption is said now
  const int code = report.finish(result, opened.note());
  if (!result.interrupted) {
    if (programs_stored.valid()) programs_stored.wait();
    opened.store_programs();  // of stages that no earlier frame needed; costs nothing when there are none
    opened.warn_of_cache();
  }
  if (!options.explain.empty() && code == exit_done) {
    const Planner planner(scene, job.plan);
    for (const std::int64_t frame : job.frames) {
      if (stop_requested()) return exit_interrupted;
      explain_method(planner, frame, options.explain, options.json);
    }
  }
  return code;
}

}  // namespace morphcl::cli
