#include "cli/render_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

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

const char* phase_name(ProgressState::Phase phase) {
  switch (phase) {
    case ProgressState::Phase::checking:
      return "checking";
    case ProgressState::Phase::compiling:
      return "compiling";
    case ProgressState::Phase::drawing:
      return "drawing";
  }
  return "drawing";
}

std::vector<std::int64_t> frames_of(const JobResult& result, Status status) {
  std::vector<std::int64_t> frames;
  for (const FrameResult& frame : result.frames)
    if (frame.status == status) frames.push_back(frame.frame);
  return frames;
}

// What the errors of several frames have in common: all but their places.
std::string reason_of(const std::string& error) {
  const std::size_t colon = error.rfind(": ");
  return colon == std::string::npos ? error : error.substr(colon + 2);
}

// In the order of their first frames.
std::vector<std::pair<std::string, std::vector<std::int64_t>>> frames_by_renderer(const JobResult& result) {
  std::vector<std::pair<std::string, std::vector<std::int64_t>>> by_renderer;
  for (const FrameResult& frame : result.frames) {
    if (frame.status != Status::rendered) continue;
    auto found = std::find_if(by_renderer.begin(), by_renderer.end(),
                              [&frame](const auto& entry) { return entry.first == frame.drawn_by; });
    if (found == by_renderer.end()) found = by_renderer.insert(found, {frame.drawn_by, std::vector<std::int64_t>()});
    found->second.push_back(frame.frame);
  }
  return by_renderer;
}

std::size_t count_of(const JobResult& result, Status status) {
  const auto is = [status](const FrameResult& frame) { return frame.status == status; };
  return static_cast<std::size_t>(std::count_if(result.frames.begin(), result.frames.end(), is));
}

std::size_t replaced_frames(const JobResult& result) {
  const auto is = [](const FrameResult& frame) { return frame.status != Status::failed && frame.replaced; };
  return static_cast<std::size_t>(std::count_if(result.frames.begin(), result.frames.end(), is));
}
}  // namespace

std::string interrupted_words(std::size_t whole, std::size_t total) {
  if (total == 0) return "interrupted before the first frame; run the same command again";
  return fmt::format("interrupted after {} of {} frames; run the same command with --resume to go on", whole, total);
}

std::string drawn_by_words(const JobResult& result) {
  const auto by_renderer = frames_by_renderer(result);
  if (by_renderer.size() == 1) return by_renderer.front().first;
  std::string words;
  for (const auto& [name, frames] : by_renderer)
    words += fmt::format("{}{} ({})", words.empty() ? "" : ", ", name, frame_ranges(frames));
  return words;
}

std::string frame_ranges(const std::vector<std::int64_t>& frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t last = i;
    while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", frames[i]);
    if (last > i) text += fmt::format("-{}", frames[last]);
    i = last + 1;
  }
  return text;
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
    : total_(total),
      settings_(std::move(settings)),
      bar_(total, {settings_.checks_first, settings_.kernels_compiled}, !settings_.json && !settings_.quiet) {}

void RenderReport::frame(const FrameResult& result) {
  bar_.advance(result.status == Status::rendered || result.status == Status::copied);
  if (result.status == Status::failed) {
    known_failed_.insert(result.frame);
    if (reasons_.insert(reason_of(result.error)).second) bar_.message(result.error);
  }
  if (!settings_.json) return;
  print_frame(result);
  if (settings_.quiet) return;
  const ProgressState state = bar_.state();
  print_progress(line_of(json_object("progress", {{"done", bar_.done()},
                                                  {"total", total_},
                                                  {"frames_per_second", state.frames_per_second},
                                                  {"seconds_left", state.seconds_left},
                                                  {"phase", phase_name(state.phase)}})));
}

void RenderReport::print_frame(const FrameResult& result) const {
  Json frame =
      json_object("frame", {{"frame", result.frame}, {"status", status_name(result.status)}, {"path", result.path}});
  if (result.status == Status::failed)
    frame.update({{"error", result.error}, {"code", result.error_code}});
  else
    frame.update({{"hash", result.hash}, {"milliseconds", result.milliseconds}, {"replaced", result.replaced}});
  if (result.status == Status::rendered) frame["drawn_by"] = result.drawn_by;
  print_result(line_of(frame));
}

// Frames that were whole when they were reported, and whose files are gone.
void RenderReport::report_lost(const JobResult& result) {
  std::vector<std::int64_t> lost;
  const FrameResult* first = nullptr;
  for (const FrameResult& frame : result.frames) {
    if (frame.status != Status::failed || known_failed_.count(frame.frame) != 0) continue;
    if (first == nullptr) first = &frame;
    lost.push_back(frame.frame);
    if (settings_.json) print_frame(frame);
  }
  if (lost.size() == 1)
    print_message(first->error);
  else if (first != nullptr)
    print_message(fmt::format("frames {}: {}", frame_ranges(lost), first->error));
}

int RenderReport::finish(const JobResult& result, const std::string& note) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  bar_.close();
  report_lost(result);
  summary(result, note, elapsed.count());
  if (!note.empty() && !settings_.quiet) print_message("note: " + note);
  if (result.interrupted)
    print_message(interrupted_words(result.frames.size() - count_of(result, Status::failed), total_));
  return exit_code(result);
}

void RenderReport::summary(const JobResult& result, const std::string& note, double seconds) const {
  const std::size_t rendered = count_of(result, Status::rendered), copied = count_of(result, Status::copied);
  const std::size_t kept = count_of(result, Status::kept), failed = count_of(result, Status::failed);
  const std::size_t replaced = replaced_frames(result);
  const double speed = seconds > 0 ? static_cast<double>(rendered + copied) / seconds : 0.0;
  if (settings_.json) {
    Json drawn_by = Json::object();
    for (const auto& [name, frames] : frames_by_renderer(result)) drawn_by[name] = frames.size();
    print_result(line_of(json_object("summary", {{"device", settings_.device},
                                                 {"total", total_},
                                                 {"rendered", rendered},
                                                 {"kept", kept},
                                                 {"copied", copied},
                                                 {"replaced", replaced},
                                                 {"failed", failed},
                                                 {"interrupted", result.interrupted},
                                                 {"seconds", seconds},
                                                 {"frames_per_second", speed},
                                                 {"code", exit_code(result)},
                                                 {"drawn_by", drawn_by},
                                                 {"note", note}})));
    return;
  }
  if (settings_.quiet || rendered + copied + kept == 0) return;
  const auto whole = [](const FrameResult& frame) { return frame.status != Status::failed; };
  const auto first = std::find_if(result.frames.begin(), result.frames.end(), whole);
  const auto last = std::find_if(result.frames.rbegin(), result.frames.rend(), whole);
  std::string line = fmt::format("{} frame{} rendered", rendered, rendered == 1 ? "" : "s");
  if (copied > 0) line += fmt::format(", {} copied", copied);
  if (replaced > 0)
    line += fmt::format(" ({} in place of files that were damaged or not of this shot and these settings)", replaced);
  if (kept > 0) line += fmt::format(", {} kept", kept);
  if (failed > 0) line += fmt::format(", {} failed ({})", failed, frame_ranges(frames_of(result, Status::failed)));
  if (const std::string who = drawn_by_words(result); !who.empty()) line += " on " + who;
  line += fmt::format(" in {:.2f} s", seconds);
  if (rendered + copied > 0) line += fmt::format(" ({:.1f} frames/s)", speed);
  line += ": " + first->path;
  if (first->frame != last->frame) line += " to " + last->path;
  for (const std::string& path : settings_.extra_outputs) line += ", " + path;
  print_result(line);
}

}  // namespace morphcl::cli
