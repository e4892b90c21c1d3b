// Where the frames of a job go: the sequence of files, and the pictures that were asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <semaphore>
#include <span>

#include "host/image/contact_sheet.hpp"
#include "host/image/exposure.hpp"
#include "host/job/equal_frames.hpp"
#include "host/job/frame_file.hpp"
#include "host/job/frame_pattern.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/job.hpp"

namespace morphcl {

// Marks `result` as failed by `error`.
void set_failed(FrameResult& result, const std::exception& error);

class FrameOutput {
 public:
  // Checks all that run() promises to find before anything is rendered, makes the output's folder, and removes what
  // killed jobs left there. `job` and `scene` have to outlive this. Of the threads that call write() at the same time,
  // at most `encoders` encode; the others wait for them or for the disk.
  // `deviation` is the renderer's.
  FrameOutput(const RenderJob& job, const Scene& scene, const std::string& deviation, int encoders);

  std::string path(std::int64_t frame) const { return pattern_.path(frame); }
  bool exists(std::int64_t frame) const;                           // whatever stands there
  const std::string& fingerprint() const { return fingerprint_; }  // of the scene, and of a renderer that deviates

  // The result of a frame that a former run finished, with its pictures drawn; nothing when it has to be rendered. May
  // be called for several frames at the same time, as may write() and copy().
  std::optional<FrameResult> keep(std::int64_t frame);

  // Writes the frame and its pictures and completes `result`, as failed when anything of it fails. Calls `pixels_done`
  // as soon as `pixels` are not needed any more, or not at all. `encoding_threads` share the encoding of the one frame.
  // Z of `pixels` may be rounded on the way, as the image's settings have it.
  WrittenFrame write(FrameBuffer& pixels, const FrameAttributes& attributes, FrameResult& result, int encoding_threads,
                     const std::function<void()>& pixels_done);

  // The same with the pixels of a frame that this job wrote, out of its file. False, and nothing done, when that file
  // is not there or not as it was written.
  bool copy(const WrittenFrame& source, const FrameAttributes& attributes, FrameResult& result);

  // Of the frames that were written or kept, those whose files are gone are marked as failed.
  void find_lost(std::vector<FrameResult>& frames) const;

  // After the last frame: writes the contact sheet.
  void finish() const;

 private:
  void check_outputs(const Scene& scene) const;
  void save(std::span<const char> file, const FrameResult& result) const;
  bool draws_pictures() const { return job_.preview || sheet_; }
  // Of one frame, by one thread; its preview is kept by the thread.
  struct FramePictures {
    std::optional<RgbImage> cell;  // of the contact sheet
  };
  FramePictures make_pictures(std::int64_t frame, const FrameBuffer& pixels) const;
  void save_pictures(const FramePictures& pictures, const FrameResult& result);

  const RenderJob& job_;
  const std::string fingerprint_;
  const ImageSettings& image_;
  const FramePattern pattern_;
  const FrameFile file_;
  std::counting_semaphore<> encoders_;
  // Of pictures: PNG frames have it in their pixels, which pictures are made of.
  const Exposure exposure_;
  std::unique_ptr<ContactSheet> sheet_;
};

}  // namespace morphcl
