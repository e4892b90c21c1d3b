// A frame's file, in the format that the job writes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/image/exposure.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/job.hpp"

namespace morphcl {

class FrameFile {
 public:
  // `compression` is of EXR files. Error(usage) when the job's settings do not go with the format that its pattern asks
  // for, or when the image has nothing that the format can hold.
  FrameFile(const RenderJob& job, const ImageSettings& image);

  // As encode_exr() and relabel_exr(). What the image's settings let an EXR file round is rounded in `frame`.
  std::string encode(std::vector<char>& bytes, FrameBuffer& frame, const FrameAttributes& attributes,
                     int threads) const;
  std::string relabel(std::vector<char>& bytes, std::span<const char> source, const FrameAttributes& attributes) const;

  // Whether a reader gets other pixels than those of the frame that was encoded, and the pixels that a reader gets.
  bool changes_pixels() const { return format_ == FrameFormat::png; }
  FrameBuffer decode(std::span<const char> bytes) const;

  // As verify_exr().
  void verify(const std::string& path, const std::string& hash) const;

  struct Finished {
    std::string hash;
    FrameAttributes attributes;
    std::optional<FrameBuffer> pixels;  // only if asked for, or if they cost nothing
  };
  // As read_finished_frame().
  std::optional<Finished> read_finished(const std::string& path, const std::string& fingerprint,
                                        bool with_pixels) const;

 private:
  const FrameFormat format_;
  const std::string compression_;
  const double z_error_, p_error_, n_error_;
  const int sample_bits_;
  const Exposure exposure_;  // of PNG files
};

}  // namespace morphcl
