#include "host/job/frame_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "host/image/atomic_file.hpp"
#include "host/image/exr_stream.hpp"
#include "host/image/pixel_hash.hpp"
#include "host/image/png_encode.hpp"
#include "host/image/thumbnail.hpp"
#include "host/temporary_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

std::string preview_path(const std::string& path) {
  std::filesystem::path preview(path);
  if (preview.extension() == ".exr") preview.replace_extension();
  preview += ".png";
  return preview.string();
}

void check_settings(const RenderJob& job, const ImageSettings& image, const FramePattern& pattern) {
  if (job.frames.size() > 1 && !pattern.has_number())
    throw Error(ErrorKind::usage, "",
                fmt::format("{} frames for the one file '{}'; put #### where the frame number belongs",
                            job.frames.size(), job.pattern));
  if ((job.preview || !job.contact_sheet.empty()) && !image.has_color())
    throw Error(ErrorKind::usage, "", "pictures show colour, and this job has none; add RGBA to the channels");
}

std::string fingerprint_of(const RenderJob& job, const Scene& scene, const std::string& deviation) {
  const std::string plain = fingerprint(scene);
  const std::string exposed = job.exposure_stops != 0 && frame_format(job.pattern) == FrameFormat::png
                                  ? text_hash(fmt::format("{} exposure {}", plain, job.exposure_stops))
                                  : plain;
  return deviation.empty() ? exposed : text_hash(exposed + deviation);
}

// The name under which an output would come to stand: its folder without links and detours, its last part as it is,
// since a link of that name is replaced and not followed.
std::string place_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  return (std::filesystem::weakly_canonical(folder, error) / path.filename()).string();
}

// The names of input files: as they were given, and of what they lead to.
std::set<std::string> places_of_inputs(const Scene& scene) {
  std::set<std::string> places;
  for (const std::string& input : scene.inputs) {
    std::error_code error;
    places.insert(place_of(input));
    places.insert(std::filesystem::weakly_canonical(input, error).string());
  }
  return places;
}

// Kept from frame to frame: the first touch of fresh memory costs more than the encoding.
thread_local std::vector<char> encoded, preview_file, read_back;

// The bytes of the file if they are what was written.
bool read_unchanged(const std::string& path, const WrittenFrame& written, std::vector<char>& bytes) {
  try {
    FileInput file(path);
    if (written.file_hash.empty() || file.size() != written.file_bytes) return false;
    bytes.resize(written.file_bytes);
    constexpr std::size_t piece = std::size_t{1} << 30;
    for (std::size_t at = 0; at < bytes.size(); at += piece)
      file.read(bytes.data() + at, static_cast<int>(std::min(piece, bytes.size() - at)));
    return text_hash({bytes.data(), bytes.size()}) == written.file_hash;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

void set_failed(FrameResult& result, const std::exception& error) {
  const auto* known = dynamic_cast<const Error*>(&error);
  const Error failure = known ? *known : Error(ErrorKind::internal, "", error.what());
  result.status = FrameResult::Status::failed;
  result.error = failure.at(fmt::format("frame {}", result.frame)).what();
  result.error_code = failure.exit_code();
}

FrameOutput::FrameOutput(const RenderJob& job, const Scene& scene, const std::string& deviation, int encoders)
    : job_(job),
      fingerprint_(fingerprint_of(job, scene, deviation)),
      image_(scene.image),
      pattern_(job.pattern),
      file_(job, image_),
      encoders_(encoders),
      exposure_(file_.changes_pixels() ? 0 : job.exposure_stops) {
  check_settings(job, image_, pattern_);
  if (job.frames.empty()) return;
  check_outputs(scene);
  remove_stale_temporaries(pattern_.before_number());
  if (job.contact_sheet.empty()) return;
  check_can_create(job.contact_sheet);
  remove_stale_temporaries(job.contact_sheet);
  sheet_ = std::make_unique<ContactSheet>(job.frames, PictureSize{image_.width, image_.height}, exposure_.gain());
}

void FrameOutput::check_outputs(const Scene& scene) const {
  const std::set<std::string> inputs = places_of_inputs(scene);
  const std::filesystem::path folder = std::filesystem::path(place_of(path(job_.frames.front()))).parent_path();
  const std::string sheet = job_.contact_sheet.empty() ? "" : place_of(job_.contact_sheet);
  const auto check = [&](const std::string& file, const std::string& place) {
    if (inputs.count(place) != 0)
      throw Error(ErrorKind::usage, file, "is a file that the scene is read from; give the output another name");
  };
  const auto check_picture = [&](const std::string& file) {
    const std::string place = (folder / std::filesystem::path(file).filename()).string();
    check(file, place);
    if (place == sheet)
      throw Error(ErrorKind::usage, job_.contact_sheet,
                  "is a picture of one frame as well; give the contact sheet another name");
  };
  std::string longest;
  for (const std::int64_t frame : job_.frames) {
    const std::string file = path(frame);
    check_picture(file);
    if (job_.preview) check_picture(preview_path(file));
    if (file.size() >= longest.size()) longest = file;
  }
  if (!sheet.empty()) check(job_.contact_sheet, sheet);
  check_can_create(path(job_.frames.front()));
  check_name_length(longest);
  if (job_.preview) check_name_length(preview_path(longest));
}

bool FrameOutput::exists(std::int64_t frame) const {
  std::error_code error;
  return std::filesystem::exists(std::filesystem::symlink_status(path(frame), error));
}

std::optional<FrameResult> FrameOutput::keep(std::int64_t frame) {
  FrameResult result;
  result.frame = frame;
  result.path = path(frame);
  result.status = FrameResult::Status::kept;
  const auto finished = file_.read_finished(result.path, fingerprint_, draws_pictures());
  if (!finished || finished->attributes.frame != frame) return std::nullopt;  // or another frame's, under this name
  result.hash = finished->hash;
  try {
    if (finished->pixels) save_pictures(make_pictures(frame, *finished->pixels), result);
  } catch (const std::exception& error) {
    set_failed(result, error);
  }
  return result;
}

WrittenFrame FrameOutput::write(FrameBuffer& pixels, const FrameAttributes& attributes, FrameResult& result,
                                int encoding_threads, const std::function<void()>& pixels_done) {
  try {
    FramePictures pictures;
    encoders_.acquire();
    try {
      result.hash = file_.encode(encoded, pixels, attributes, encoding_threads);
      if (file_.changes_pixels() && draws_pictures())
        pictures = make_pictures(result.frame, file_.decode(encoded));  // as of a frame that is kept or copied
      else
        pictures = make_pictures(result.frame, pixels);
    } catch (...) {
      encoders_.release();
      throw;
    }
    encoders_.release();
    pixels_done();
    save(encoded, result);
    save_pictures(pictures, result);
    if (!job_.reuse_equal_frames) return {};
    return {result.frame, encoded.size(), text_hash({encoded.data(), encoded.size()})};
  } catch (const std::exception& error) {
    set_failed(result, error);
    return {};
  }
}

bool FrameOutput::copy(const WrittenFrame& source, const FrameAttributes& attributes, FrameResult& result) {
  if (!read_unchanged(path(source.frame), source, read_back)) return false;
  try {
    result.hash = file_.relabel(encoded, read_back, attributes);
    save(encoded, result);
    if (draws_pictures()) save_pictures(make_pictures(result.frame, file_.decode(encoded)), result);
  } catch (const std::exception& error) {
    set_failed(result, error);
  }
  return true;
}

void FrameOutput::save(std::span<const char> file, const FrameResult& result) const {
  write_file_atomically(result.path, file);
  if (job_.verify) file_.verify(result.path, result.hash);
}

void FrameOutput::find_lost(std::vector<FrameResult>& frames) const {
  for (FrameResult& frame : frames) {
    if (frame.status == FrameResult::Status::failed) continue;
    std::error_code error;
    if (!std::filesystem::is_regular_file(frame.path, error))
      set_failed(frame, Error(ErrorKind::cannot_create, frame.path, "was written, and has gone while the job ran"));
  }
}

void FrameOutput::finish() const {
  if (sheet_) sheet_->write(job_.contact_sheet);
}

FrameOutput::FramePictures FrameOutput::make_pictures(std::int64_t frame, const FrameBuffer& pixels) const {
  FramePictures pictures;
  if (job_.preview) encode_png_over(preview_file, pixels, picture_background, exposure_);
  if (sheet_) pictures.cell = sheet_->picture_of(frame, pixels);
  return pictures;
}

void FrameOutput::save_pictures(const FramePictures& pictures, const FrameResult& result) {
  if (job_.preview) write_file_atomically(preview_path(result.path), preview_file);
  if (pictures.cell) sheet_->add(result.frame, *pictures.cell);
}

}  // namespace morphcl
