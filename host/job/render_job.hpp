// Renders a range of frames into files: overlap of rendering and writing, resume, verification, truthful result.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/render/renderer.hpp"
#include "host/scene/scene.hpp"

namespace morphcl {

// "7", "1-10", "1-10x2", commas between; negative numbers allowed ("-5--1"). Error(usage) explains what is wrong; a ':'
// is refused with the reason.
std::vector<FrameRange> parse_frame_range(const std::string& text);
// Every frame once, in ascending order. At most 1,000,000 frames, |frame| <= 1,000,000, else Error(usage).
std::vector<std::int64_t> frame_numbers(const std::vector<FrameRange>& ranges);

// A file name pattern: a run of two or more '#' is that many digits, a lone '#' is four, %0Nd is N digits. Error(usage)
// when there is none although several frames are asked for, or more than one.
class FramePattern {
 public:
  explicit FramePattern(const std::string& pattern);
  std::string path(std::int64_t frame) const;
  bool has_number() const { return has_number_; }

 private:
  std::string before_, after_;
  int digits_ = 0;
  bool has_number_ = false;
};

struct FrameResult {
  std::int64_t frame = 0;
  std::string path;
  std::string hash;
  enum class Status { rendered, kept, failed } status = Status::rendered;
  std::string error;  // one line, when failed
  int error_code = 0; // the exit code of that error's kind
  double milliseconds = 0;  // drawing alone
};

struct RenderJob {
  std::string pattern;
  std::vector<std::int64_t> frames;
  bool resume = false;  // keep the finished frames of the same fingerprint
  bool verify = false;  // read every frame back after it was written
  int frames_in_flight = 2;
  std::string fingerprint;  // fingerprint(scene)
  std::function<void(const FrameResult&)> on_frame;  // called in order of completion, from one thread at a time
  const std::atomic<bool>* stop = nullptr;           // set: finish what is being written and return
};

struct JobResult {
  std::vector<FrameResult> frames;  // in ascending order, only those that were reached
  bool interrupted = false;
};

// Of everything that decides the pixels: the scene's content hash, image settings, fps, morphcl's version.
std::string fingerprint(const Scene& scene);

// Frames that fail do not stop the others, except when the output cannot be created at all: then Error is thrown before
// anything was rendered.
JobResult run(const RenderJob& job, const Scene& scene, Renderer& renderer);

}  // namespace morphcl
