// What a render job tells: frames as they finish, failures, and the line at the end.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cli/progress_bar.hpp"
#include "morphcl/job.hpp"

namespace morphcl::cli {

class RenderReport {
 public:
  struct Settings {
    std::string device;
    std::vector<std::string> extra_outputs;         // the contact sheet
    bool checks_first = false;                      // finished frames are looked for before any is drawn
    std::function<std::size_t()> kernels_compiled;  // so far; for any thread; empty: nothing is compiled
    bool json = false;
    bool quiet = false;
  };
  RenderReport(std::size_t total, Settings settings);

  void checked() { bar_.checked(); }  // a frame was looked for
  void drawn() { bar_.drawn(); }      // a frame, which is not written yet
  // With --json one object on stdout a frame, and one on stderr for the progress unless quiet. A failure is one line on
  // stderr, and those that follow for the same reason none: finish() counts them.
  void frame(const FrameResult& result);

  // The closing line or object on stdout, and on stderr the message of an interrupted job and `note`, unless it is "":
  // what is to be said of who drew. Returns the exit code.
  int finish(const JobResult& result, const std::string& note);

 private:
  void report_lost(const JobResult& result);
  void print_frame(const FrameResult& result) const;
  void summary(const JobResult& result, const std::string& note, double seconds) const;

  std::size_t total_;
  Settings settings_;
  ProgressBar bar_;
  std::set<std::string> reasons_;        // of failures
  std::set<std::int64_t> known_failed_;  // frames
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// What a job that is stopped says: "interrupted after 3 of 101 frames; ...". `total` is 0 while the scene is loaded.
std::string interrupted_words(std::size_t whole, std::size_t total);

// Who drew the frames of a job: "reference", or "reference (0-37), DEVICE (38-99)". "" when none was drawn.
std::string drawn_by_words(const JobResult& result);

// "0-38, 40"
std::string frame_ranges(const std::vector<std::int64_t>& frames);

// 75 when interrupted; 0 when no frame failed; the failures' common code when no frame was written, or when all of them
// are failed writes (74: the disk is full); else 1.
int exit_code(const JobResult& result);

}  // namespace morphcl::cli
