#include "cli/render_command.hpp"

#include <future>

#include "cli/console.hpp"
#include "cli/render_report.hpp"
#include "cli/stop_signals.hpp"
#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::cli {

int render_command(const RenderOptions& options) {
  const std::atomic<bool>& stop = stop_requested();
  std::optional<std::vector<FrameRange>>
      ranges;  // read first, so that a wrong one is reported before a large file is read
  if (options.frames) ranges = parse_frame_range(*options.frames);

  Scene scene = open_scene(options.scene);
  if (ranges) scene.frames = *ranges;
  print_warnings(scene);

  RenderJob job;
  job.pattern = options.pattern.value_or(scene.name + ".####.exr");
  job.frames = frame_numbers(scene.frames);
  job.resume = options.resume;
  job.verify = options.verify;
  job.plan.leave_out = options.leave_out;
  job.reuse_equal_frames = options.leave_out;
  job.contact_sheet = options.contact_sheet;
  job.preview = options.preview;
  job.stop = &stop;

  const OpenedRenderer opened = open_renderer(options.device);
  job.threads = opened.threads;
  RenderReport::Settings settings;
  settings.device = opened.device_name;
  if (!options.contact_sheet.empty()) settings.extra_outputs.push_back(options.contact_sheet);
  settings.json = options.json;
  settings.quiet = options.quiet;
  RenderReport report(job.frames.size(), settings);
  std::future<void> programs_stored;  // from the first frame on, as it takes about as long as compiling them did
  job.on_frame = [&](const FrameResult& result) {
    report.frame(result);
    if (result.status == FrameResult::Status::rendered && !programs_stored.valid())
      programs_stored = std::async(std::launch::async, [&opened] { opened.store_programs(); });
  };
  const JobResult result = run(job, scene, *opened.renderer);
  if (programs_stored.valid()) {
    programs_stored.wait();
    opened.store_programs();  // of stages that no earlier frame needed; costs nothing when there are none
  }
  return report.finish(result);
}

}  // namespace morphcl::cli
