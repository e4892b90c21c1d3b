#include "host/job/frame_output.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "host/error.hpp"
#include "host/image/atomic_file.hpp"
#include "host/image/exr_file.hpp"

namespace morphcl {

namespace {

std::string preview_path(const std::string& path) {
  std::filesystem::path preview(path);
  if (preview.extension() == ".exr") preview.replace_extension();
  preview += ".png";
  return preview.string();
}

void check_settings(const RenderJob& job, const ImageSettings& image, const FramePattern& pattern) {
  check_compression(image.compression);
  if (job.frames.size() > 1 && !pattern.has_number())
    throw Error(ErrorKind::usage, "",
                fmt::format("{} frames for the one file '{}'; put #### where the frame number belongs",
                            job.frames.size(), job.pattern));
  if ((job.preview || !job.contact_sheet.empty()) && !image.color)
    throw Error(ErrorKind::usage, "", "pictures show colour, and this job has none; add RGBA to the channels");
}

}  // namespace

void set_failed(FrameResult& result, const std::exception& error) {
  const auto* known = dynamic_cast<const Error*>(&error);
  const Error failure = known ? *known : Error(ErrorKind::internal, "", error.what());
  result.status = FrameResult::Status::failed;
  result.error = failure.at(fmt::format("frame {}", result.frame)).what();
  result.error_code = failure.exit_code();
}

FrameOutput::FrameOutput(const RenderJob& job, const ImageSettings& image)
    : job_(job), image_(image), pattern_(job.pattern) {
  check_settings(job, image, pattern_);
  if (job.frames.empty()) return;
  check_can_create(path(job.frames.front()));
  remove_stale_temporaries(pattern_.before_number());
  if (job.contact_sheet.empty()) return;
  check_can_create(job.contact_sheet);
  remove_stale_temporaries(job.contact_sheet);
  sheet_ = std::make_unique<ContactSheet>(job.frames, PictureSize{image.width, image.height});
}

std::optional<FrameResult> FrameOutput::keep(std::int64_t frame) {
  FrameResult result;
  result.frame = frame;
  result.path = path(frame);
  result.status = FrameResult::Status::kept;
  const std::optional<ExrFrame> finished = read_finished_frame(result.path, job_.fingerprint);
  if (!finished) return std::nullopt;
  result.hash = finished->hash;
  try {
    draw_pictures(result, finished->frame);
  } catch (const std::exception& error) {
    set_failed(result, error);
  }
  return result;
}

void FrameOutput::write(const FrameBuffer& pixels, const FrameAttributes& attributes, FrameResult& result,
                        int threads) {
  try {
    result.hash = write_exr(result.path, pixels, attributes, image_.compression, threads);
    if (job_.verify) verify_exr(result.path, result.hash);
    draw_pictures(result, pixels);
  } catch (const std::exception& error) {
    set_failed(result, error);
  }
}

void FrameOutput::finish() const {
  if (sheet_) sheet_->write(job_.contact_sheet);
}

void FrameOutput::draw_pictures(const FrameResult& result, const FrameBuffer& pixels) {
  if (job_.preview) write_png(preview_path(result.path), thumbnail(pixels, {pixels.width(), pixels.height()}));
  if (sheet_) sheet_->add(result.frame, pixels);
}

}  // namespace morphcl
