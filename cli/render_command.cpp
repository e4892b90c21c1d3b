#include "cli/render_command.hpp"

#include <filesystem>

#include "cli/console.hpp"
#include "cli/render_report.hpp"
#include "cli/stop_signals.hpp"
#include "host/error.hpp"
#include "host/scene/frame_range.hpp"

namespace morphcl::cli {

int render_command(const RenderOptions& options) {
  const std::atomic<bool>& stop = stop_requested();
  std::vector<FrameRange> ranges;
  if (!options.frames.empty()) ranges = parse_frame_range(options.frames);

  Scene scene = open_scene(options.scene);
  if (!ranges.empty()) scene.frames = ranges;
  for (const std::string& warning : scene.warnings) print_message("warning: " + printable(warning));

  RenderJob job;
  job.pattern = options.pattern.empty() ? scene.name + ".####.exr" : options.pattern;
  job.frames = frame_numbers(scene.frames);
  job.resume = options.resume;
  job.verify = options.verify;
  job.fingerprint = fingerprint(scene);
  job.contact_sheet = options.contact_sheet;
  job.preview = options.preview;
  job.stop = &stop;

  const OpenedRenderer opened = open_renderer(options.device);
  RenderReport::Settings settings;
  settings.device = opened.device_name;
  if (!options.contact_sheet.empty()) settings.extra_outputs.push_back(options.contact_sheet);
  settings.json = options.json;
  settings.quiet = options.quiet;
  RenderReport report(job.frames.size(), settings);
  job.on_frame = [&report](const FrameResult& result) { report.frame(result); };
  const JobResult result = run(job, scene, *opened.renderer);
  const int code = report.finish(result);
  opened.store_programs();
  return code;
}

}  // namespace morphcl::cli
