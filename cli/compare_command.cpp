#include "cli/compare_command.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <span>

#include "cli/compare_coverage.hpp"
#include "cli/compare_report.hpp"
#include "cli/compare_summary.hpp"
#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "host/image/atomic_file.hpp"
#include "host/job/frame_pattern.hpp"
#include "host/memory_room.hpp"
#include "host/scene/model/base_color.hpp"
#include "lab/frame_error/difference_files.hpp"
#include "morphcl/error.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::cli {

namespace {

using accuracy::FrameDifference;
using accuracy::Truth;

constexpr std::uint64_t bytes_per_compared_pixel = 80;  // measured: 72 and the frame

std::vector<Truth> truths(const std::string& name) {
  if (name == "grid") return {Truth::on_grid};
  if (name == "true") return {Truth::true_geometry};
  return {Truth::on_grid, Truth::true_geometry};
}

std::vector<std::int64_t> frames_to_compare(const CompareOptions& options, const Scene& scene) {
  if (options.frame) return {*options.frame};
  if (options.frames) return frame_numbers(parse_frame_range(*options.frames));
  return {frame_numbers(scene.frames).front()};
}

// The fp64 render sees what is at a pixel's centre, and lines one pixel wide, and has no channels but RGBA and Z. The
// same is drawn, and said where the shot asks for more.
void compare_at_centres(Scene& scene) {
  if (!(scene.image.channels - default_channels).empty())
    print_message("note: compared are RGBA and Z, not the other channels of the shot");
  scene.image.channels = scene.image.channels & default_channels;
  if (scene.image.channels.empty()) scene.image.channels = default_channels;
  scene.image.p_error = scene.image.n_error = 0;
  if (scene.image.samples > 1 && scene.image.has_color())
    print_message(
        fmt::format("note: compared is one sample a pixel, its centre, not the {} of the shot; see "
                    "docs/frame-error.md",
                    scene.image.samples));
  scene.image.samples = 1;
  for (Object& object : scene.objects) {
    double& width = object.material.line_width;
    if (object.material.shading == Shading::wireframe && width != 1)
      print_message(fmt::format("note: {}: lines are compared one pixel wide, not {}; see docs/frame-error.md",
                                object.name, width));
    width = 1;
    if ((object.material.base_color.a < 1 || moves_alpha(object.material)) &&
        object.material.alpha_mode == AlphaMode::blend)
      print_message(fmt::format("note: {}: is compared as if it were opaque; see docs/frame-error.md", object.name));
    object.material.alpha_mode = AlphaMode::opaque;
  }
}

// EXR, PNG and CSV of a folder: NAME.0057.grid.exr, NAME.0057.grid.png, NAME.csv.
class Files {
 public:
  Files(const std::string& folder, const Scene& scene)
      : folder_(folder), name_(scene.name), csv_(accuracy::csv_header()) {
    if (!folder_.empty()) check_can_create(path(name_ + ".csv"));
  }

  void add(const FrameDifference& difference) {
    if (folder_.empty()) return;
    const std::string stem =
        FramePattern(name_ + ".####." + accuracy::name_of(difference.truth)).path(difference.frame);
    accuracy::write_difference_exr(path(stem + ".exr"), difference);
    write_png(path(stem + ".png"), accuracy::difference_picture(difference));
    csv_ += accuracy::csv_lines(difference);
  }

  void finish() const {
    if (!folder_.empty()) write_file_atomically(path(name_ + ".csv"), csv_);
  }

 private:
  std::string path(const std::string& name) const { return (std::filesystem::path(folder_) / name).string(); }

  std::string folder_, name_, csv_;
};

}  // namespace

int compare_command(const CompareOptions& options) {
  if (options.frames) parse_frame_range(*options.frames);  // a wrong one is reported before a large file is read
  Scene scene = open_scene(options.scene);
  const std::vector<std::int64_t> frames = frames_to_compare(options, scene);
  print_warnings(scene);
  if (options.truth == "coverage") return compare_coverage(options, scene, frames);
  compare_at_centres(scene);
  Files files(options.out, scene);
  require_memory(bytes_per_compared_pixel * static_cast<std::uint64_t>(scene.image.width) *
                     static_cast<std::uint64_t>(scene.image.height),
                 fmt::format("comparing a frame of {}x{}", scene.image.width, scene.image.height),
                 "a smaller size takes less");
  const OpenedRenderer opened = open_renderer(options.device);
  const Planner planner(scene);
  const std::vector<Truth> compared = truths(options.truth);
  std::vector<CompareSummary> summaries(compared.begin(), compared.end());
  auto left = static_cast<std::int64_t>(frames.size());
  for (const std::int64_t frame : frames) {
    opened.renderer->expect_frames(left--);
    const Plan plan = planner.plan(frame);
    accuracy::check_comparable(*plan);
    FrameBuffer pixels = plan.make_frame();
    opened.renderer->render(plan, pixels);
    const std::vector<reference::ShownPixel> shown = reference::shown_pixels(*plan);
    for (std::size_t i = 0; i < compared.size(); ++i) {
      const FrameDifference difference = accuracy::compare_with_fp64(scene, *plan, pixels, shown, compared[i]);
      summaries[i].add(difference);
      if (options.json)
        print_difference_json(difference, opened.renderer->drawn_by());
      else
        print_difference_table(difference, opened.renderer->drawn_by());
      files.add(difference);
    }
  }
  for (const CompareSummary& summary : summaries)
    print_result(options.json ? line_of(summary.json()) : summary.words());
  opened.store_programs();
  opened.warn_of_cache();
  if (const std::string note = opened.note(); !note.empty()) print_message("note: " + note);
  files.finish();
  return exit_done;
}

}  // namespace morphcl::cli
