#include "cli/render_report.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/json_object.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {
using Status = FrameResult::Status;

const char* status_name(Status status) {
  switch (status) {
    case Status::rendered:
      return "rendered";
    case Status::copied:
      return "copied";
    case Status::kept:
      return "kept";
    case Status::failed:
      return "failed";
  }
  return "failed";
}

std::size_t count_of(const JobResult& result, Status status) {
  const auto is = [status](const FrameResult& frame) { return frame.status == status; };
  return static_cast<std::size_t>(std::count_if(result.frames.begin(), result.frames.end(), is));
}
}  // namespace

std::string interrupted_words(std::size_t whole, std::size_t total) {
  if (total == 0) return "interrupted before the first frame; run the same command again";
  return fmt::format("interrupted after {} of {} frames; run the same command with --resume to go on", whole, total);
}

int exit_code(const JobResult& result) {
  if (result.interrupted) return exit_interrupted;
  const std::size_t failed = count_of(result, Status::failed);
  if (failed == 0) return exit_done;
  int common = 0;
  for (const FrameResult& frame : result.frames) {
    if (frame.status != Status::failed) continue;
    if (common != 0 && frame.error_code != common) return exit_frames_failed;
    common = frame.error_code;
  }
  const bool nothing_written = failed == result.frames.size();
  return nothing_written || common == static_cast<int>(ErrorKind::write_failed) ? common : exit_frames_failed;
}

RenderReport::RenderReport(std::size_t total, Settings settings)
    : total_(total), settings_(std::move(settings)), bar_(total, !settings_.json && !settings_.quiet) {}

void RenderReport::frame(const FrameResult& result) {
  bar_.advance(result.status == Status::rendered || result.status == Status::copied);
  if (result.status == Status::failed) bar_.message(result.error);
  if (!settings_.json) return;
  Json frame =
      json_object("frame", {{"frame", result.frame}, {"status", status_name(result.status)}, {"path", result.path}});
  if (result.status == Status::failed)
    frame.update({{"error", result.error}, {"code", result.error_code}});
  else
    frame.update({{"hash", result.hash}, {"milliseconds", result.milliseconds}});
  print_result(line_of(frame));
  if (settings_.quiet) return;
  print_progress(line_of(json_object("progress", {{"done", bar_.done()},
                                                  {"total", total_},
                                                  {"frames_per_second", bar_.frames_per_second()},
                                                  {"seconds_left", bar_.seconds_left()}})));
}

int RenderReport::finish(const JobResult& result) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  bar_.close();
  summary(result, elapsed.count());
  if (result.interrupted)
    print_message(interrupted_words(result.frames.size() - count_of(result, Status::failed), total_));
  return exit_code(result);
}

void RenderReport::summary(const JobResult& result, double seconds) const {
  const std::size_t rendered = count_of(result, Status::rendered), copied = count_of(result, Status::copied);
  const std::size_t kept = count_of(result, Status::kept), failed = count_of(result, Status::failed);
  const double speed = seconds > 0 ? static_cast<double>(rendered + copied) / seconds : 0.0;
  if (settings_.json) {
    print_result(line_of(json_object("summary", {{"device", settings_.device},
                                                 {"total", total_},
                                                 {"rendered", rendered},
                                                 {"kept", kept},
                                                 {"copied", copied},
                                                 {"failed", failed},
                                                 {"interrupted", result.interrupted},
                                                 {"seconds", seconds},
                                                 {"frames_per_second", speed},
                                                 {"code", exit_code(result)}})));
    return;
  }
  if (settings_.quiet || rendered + copied + kept == 0) return;
  const auto whole = [](const FrameResult& frame) { return frame.status != Status::failed; };
  const auto first = std::find_if(result.frames.begin(), result.frames.end(), whole);
  const auto last = std::find_if(result.frames.rbegin(), result.frames.rend(), whole);
  std::string line = fmt::format("{} frames rendered", rendered);
  if (copied > 0) line += fmt::format(", {} copied", copied);
  if (kept > 0) line += fmt::format(", {} kept", kept);
  if (failed > 0) line += fmt::format(", {} failed", failed);
  line += fmt::format(" on {} in {:.2f} s ({:.1f} frames/s): {}", settings_.device, seconds, speed, first->path);
  if (first->frame != last->frame) line += " to " + last->path;
  for (const std::string& path : settings_.extra_outputs) line += ", " + path;
  print_result(line);
}

}  // namespace morphcl::cli
