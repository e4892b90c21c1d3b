// Where the frames of a job go: the EXR sequence, and the pictures that were asked for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "host/image/contact_sheet.hpp"
#include "host/image/frame_attributes.hpp"
#include "host/job/render_job.hpp"

namespace morphcl {

// Marks `result` as failed by `error`.
void set_failed(FrameResult& result, const std::exception& error);

class FrameOutput {
 public:
  // Checks all that run() promises to find before anything is rendered, makes the output's folder, and removes what
  // killed jobs left there. `job` and `image` have to outlive this.
  FrameOutput(const RenderJob& job, const ImageSettings& image);

  std::string path(std::int64_t frame) const { return pattern_.path(frame); }

  // The result of a frame that a former run finished, with its pictures drawn; nothing when it has to be rendered. May
  // be called for several frames at the same time, as may write().
  std::optional<FrameResult> keep(std::int64_t frame);

  // Writes the frame and its pictures and completes `result`, as failed when anything of it fails.
  void write(const FrameBuffer& pixels, const FrameAttributes& attributes, FrameResult& result, int threads);

  // After the last frame: writes the contact sheet.
  void finish() const;

 private:
  void draw_pictures(const FrameResult& result, const FrameBuffer& pixels);

  const RenderJob& job_;
  const ImageSettings& image_;
  const FramePattern pattern_;
  std::unique_ptr<ContactSheet> sheet_;
};

}  // namespace morphcl
