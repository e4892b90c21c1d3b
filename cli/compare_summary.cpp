#include "cli/compare_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/render_report.hpp"
#include "lab/frame_error/difference_files.hpp"

namespace morphcl::cli {

void CompareSummary::Errors::add(const accuracy::Tally& errors, std::int64_t in_frame) {
  if (tally.count == 0 || errors.largest > tally.largest) frame = in_frame;
  tally.count += errors.count;
  tally.not_finite += errors.not_finite;
  tally.largest = std::max(tally.largest, errors.largest);
  tally.squares += errors.squares;
}

void CompareSummary::add(const accuracy::FrameDifference& frame) {
  const accuracy::Differences& all = frame.total;
  frames_.push_back(frame.frame);
  has_color_ = has_color_ || frame.has_color;
  has_depth_ = has_depth_ || frame.has_depth;
  color_.add(all.color.all, frame.frame);
  depth_.add(all.depth.all, frame.frame);
  pixels_ += all.pixels;
  const std::size_t others = all.outline + all.edge + all.order;
  other_surface_ += others;
  if (frames_.size() == 1 || others > most_others_) {
    most_others_ = others;
    most_others_frame_ = frame.frame;
  }
}

std::string CompareSummary::words() const {
  const bool several = frames_.size() > 1;
  const auto at = [several](std::int64_t frame) { return several ? fmt::format(" (frame {})", frame) : std::string(); };
  const auto error = [&at](const Errors& errors, const char* unit) {
    std::string text = fmt::format("by at most {:.2g}{}{}, typically by {:.2g}", errors.tally.largest, unit,
                                   at(errors.frame), errors.tally.rms());
    if (errors.tally.not_finite > 0) text += fmt::format(", and {} times by no number", errors.tally.not_finite);
    return text;
  };
  constexpr std::size_t longest_list = 30;
  std::string frames = frame_ranges(frames_);
  if (frames.size() > longest_list)
    frames = fmt::format("{} to {} ({} of them)", frames_.front(), frames_.back(), frames_.size());
  std::string line =
      fmt::format("frame{} {}, {}: ", several ? "s" : "", frames,
                  truth_ == accuracy::Truth::on_grid ? "against fp64 on the same grid"
                                                     : "against fp64 with vertices where they truly are");
  if (has_color_) line += "colour differs " + error(color_, "") + "; ";
  if (has_depth_) line += (has_color_ ? "Z " : "Z differs ") + error(depth_, " of the distance") + "; ";
  line += fmt::format("{} of {} pixels show another surface", other_surface_, pixels_);
  if (several && other_surface_ > 0) line += fmt::format(", at most {}{}", most_others_, at(most_others_frame_));
  return line;
}

Json CompareSummary::json() const {
  Json object = json_object("range_error", {{"truth", accuracy::name_of(truth_)},
                                            {"frames", frames_.size()},
                                            {"first", frames_.empty() ? 0 : frames_.front()},
                                            {"last", frames_.empty() ? 0 : frames_.back()},
                                            {"pixels", pixels_},
                                            {"other_surface", other_surface_},
                                            {"other_surface_most", most_others_},
                                            {"other_surface_most_frame", most_others_frame_}});
  const auto add_errors = [&object](const std::string& what, const Errors& errors) {
    object.update({{what + "_max", errors.tally.largest},
                   {what + "_max_frame", errors.frame},
                   {what + "_rms", errors.tally.rms()},
                   {what + "_not_finite", errors.tally.not_finite}});
  };
  if (has_color_) add_errors("color", color_);
  if (has_depth_) add_errors("depth", depth_);
  return object;
}

}  // namespace morphcl::cli
