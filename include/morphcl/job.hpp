// Renders a range of frames into files: overlap of rendering and writing, resume, verification, truthful result.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

struct FrameResult {
  std::int64_t frame = 0;
  std::string path;
  std::string hash;  // the pixel hash in the file
  // copied: the job had written a frame with the same picture; its encoded pixels were copied, with this frame's
  // number. kept: a former run had written it.
  enum class Status { rendered, copied, kept, failed } status = Status::rendered;
  std::string error;        // one line, when failed
  int error_code = 0;       // the exit code of that error's kind
  double milliseconds = 0;  // drawing alone; 0 unless it was rendered
  // Of a resumed job's frame that was rendered or copied: a file stood under its name that was not kept, since it was
  // damaged, or of another shot, other settings or another frame.
  bool replaced = false;
  std::string drawn_by;  // Renderer::drawn_by(); "" unless it was rendered
};

enum class FrameFormat { exr, png };

// What the pattern's ending asks for: .exr or .png, in any case. Error(usage) for another ending or none says what can
// be done instead.
FrameFormat frame_format(const std::string& pattern);

constexpr double max_exposure_stops = 30;

struct RenderJob {
  // A path whose file name holds at most one place for the frame number: a run of two or more '#' is that many digits,
  // a lone '#' is four, %0Nd is N digits (N at most 20), %d is as many as needed. Shorter numbers get zeros in front,
  // longer ones are not cut; a minus sign comes before the digits. In folders '#' and '%' are no places. It ends in
  // .exr for EXR files with the scene's channels and compression, or in .png for PNG files (png.hpp). Those hold RGBA
  // alone: Z is left out (where the scene has it, it is drawn all the same), compression and previews are not theirs.
  std::string pattern;
  std::vector<std::int64_t> frames = {};  // each once, which is not tested; empty: those of the scene
  bool resume = false;                    // keep the finished frames of the same fingerprint
  bool verify = false;  // read every frame back after it was written; one that reads back differently is removed
  // A frame whose plan shows the same picture as one that this job has written is copied from that one's file.
  bool reuse_equal_frames = true;
  // CPU threads that compress while the next frame is drawn; at most 8; 0: one for each CPU of the process.
  int threads = 0;
  // Frame buffers, the one being drawn included; 0: one more than threads, but at most 2 GiB of them (two at least). A
  // buffer is free as soon as its frame is encoded; threads + 4 encoded frames at most are on their way to the disk, of
  // large frames fewer, so that drawing does not wait for each flush. Where a container, ulimit -v or the machine
  // leaves less memory than that takes, there are fewer of both; Error(no_device) where there is not enough for one.
  int frames_in_flight = 0;
  int sample_bits = 8;             // of a sample of PNG frames: 8 or 16
  PlanOptions plan = {};           // what is left out of frames; their pixels are the same
  std::string contact_sheet = {};  // a PNG of all frames, kept ones included; empty: none
  // What colours of PNG frames, previews and the contact sheet are multiplied by, as a power of 2, before they are
  // encoded; at most max_exposure_stops either way. EXR frames stay as they are.
  double exposure_stops = 0;
  bool preview = false;  // a PNG beside each frame, its name ending in .png instead of .exr
  // Of a resumed job: called as on_frame is, and before it, when a frame was looked for, whether it is kept or not.
  // Drawing begins when it was called for all.
  std::function<void(std::int64_t)> on_checked = {};
  // Called from run()'s thread with the number of a frame that is drawn and goes to be written.
  std::function<void(std::int64_t)> on_drawn = {};
  std::function<void(const FrameResult&)> on_frame = {};  // called in order of completion, from one thread at a time
  // Set by another thread or a signal: what was drawn is finished and written. It has to outlive run().
  const std::atomic<bool>* stop = nullptr;
};

struct JobResult {
  // In ascending order, only those that were reached. A frame that was written, and whose file is gone at the end,
  // since somebody removed the folder, has failed, without a further call of on_frame.
  std::vector<FrameResult> frames;
  bool interrupted = false;  // the stop flag was seen before all frames were reached
};

// Frames that fail do not stop the others. Thrown before anything was rendered: Error(usage) for a scene that is not
// valid, a pattern without a number although several frames are asked for, a pattern that is none or has another
// ending, an unknown compression, other PNG bits than 8 and 16, PNG frames or pictures of a scene without colour,
// previews of PNG frames, an exposure out of range, or an output that is one of the scene's inputs or another output;
// Error(cannot_create) when the output cannot be created. Thrown after the frames: the Error of the contact sheet. What
// on_frame or on_checked throws stops the job, without a contact sheet, and is thrown when the frames under way are
// written. Temporary files that killed jobs of the same pattern left are removed. The renderer forgets
// (Renderer::forget) before and after.
JobResult run(const RenderJob& job, const Scene& scene, Renderer& renderer);

// By it a resumed job knows its own frames; their files hold it. 32 hex digits over everything that decides a frame's
// file but its number: the image's settings, meshes, objects, nodes, tracks, camera, lights and stated accuracy, every
// byte that was read for the scene, and morphcl's version. Frame range, names, warnings and device are not in it. Files
// that a renderer with a deviation() has drawn, and PNG files of another exposure than 0, hold another fingerprint, of
// that and of this.
std::string fingerprint(const Scene& scene);

}  // namespace morphcl
#pragma GCC visibility pop
