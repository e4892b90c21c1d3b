#include "host/job/frame_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "host/image/exr_encode.hpp"
#include "host/image/exr_relabel.hpp"
#include "host/image/png_encode.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

double checked_stops(const RenderJob& job) {
  if (!(std::abs(job.exposure_stops) <= max_exposure_stops))
    throw Error(ErrorKind::usage, "",
                fmt::format("an exposure of {} stops; -{} to {} are possible", job.exposure_stops, max_exposure_stops,
                            max_exposure_stops));
  return job.exposure_stops;
}

}  // namespace

FrameFile::FrameFile(const RenderJob& job, const ImageSettings& image)
    : format_(frame_format(job.pattern)),
      compression_(image.compression),
      z_error_(image.z_error),
      p_error_(image.p_error),
      n_error_(image.n_error),
      sample_bits_(job.sample_bits),
      exposure_(checked_stops(job)) {
  if (format_ == FrameFormat::exr)
    check_compression(compression_, image.channels);
  else
    check_compression(compression_);
  check_png_bits(sample_bits_);
  if (format_ == FrameFormat::exr && sample_bits_ != 8)
    throw Error(ErrorKind::usage, "", "PNG bits for EXR frames; end the output in .png, or leave them at 8");
  if (format_ == FrameFormat::exr) return;
  if (!image.has_color())
    throw Error(
        ErrorKind::usage, "",
        "PNG frames hold RGBA alone, and this job has no RGBA; add it to the channels, or end the output in .exr");
  if (job.preview)
    throw Error(ErrorKind::usage, "",
                "previews are PNG files beside EXR frames, and these frames are PNG files already");
}

std::string FrameFile::encode(std::vector<char>& bytes, FrameBuffer& frame, const FrameAttributes& attributes,
                              int threads) const {
  if (format_ == FrameFormat::png) return encode_png(bytes, frame, attributes, sample_bits_, threads, exposure_);
  if (z_error_ != 0) round_depth(frame, z_error_);
  if (p_error_ != 0) round_position(frame, p_error_);
  if (n_error_ != 0) round_normal(frame, n_error_);
  return encode_exr(bytes, frame, attributes, compression_, threads);
}

std::string FrameFile::relabel(std::vector<char>& bytes, std::span<const char> source,
                               const FrameAttributes& attributes) const {
  return format_ == FrameFormat::exr ? relabel_exr(bytes, source, attributes) : relabel_png(bytes, source, attributes);
}

FrameBuffer FrameFile::decode(std::span<const char> bytes) const {
  return format_ == FrameFormat::exr ? decode_exr(bytes).frame : decode_png(bytes).frame;
}

void FrameFile::verify(const std::string& path, const std::string& hash) const {
  if (format_ == FrameFormat::exr)
    verify_exr(path, hash);
  else
    verify_png(path, hash);
}

std::optional<FrameFile::Finished> FrameFile::read_finished(const std::string& path, const std::string& fingerprint,
                                                            bool with_pixels) const {
  if (format_ == FrameFormat::exr) {
    std::optional<ExrFrame> found = read_finished_frame(path, fingerprint);
    if (!found) return std::nullopt;
    return Finished{found->hash, found->attributes, std::move(found->frame)};
  }
  std::optional<PngDescription> found = finished_png(path, fingerprint, sample_bits_);
  if (!found) return std::nullopt;
  Finished finished{found->hash, found->attributes, std::nullopt};
  try {
    if (with_pixels) finished.pixels = read_png(path).frame;
  } catch (const Error&) {
    return std::nullopt;  // it has gone meanwhile
  }
  return finished;
}

}  // namespace morphcl
