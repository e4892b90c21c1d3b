#include "cli/compare_coverage.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/json_object.hpp"
#include "cli/render_report.hpp"
#include "cli/stop_signals.hpp"
#include "cli/table.hpp"
#include "host/image/atomic_file.hpp"
#include "host/thread_count.hpp"
#include "lab/exact_coverage/coverage_error.hpp"
#include "morphcl/planner.hpp"

namespace morphcl::cli {

namespace {

using accuracy::CoverageError;
using accuracy::CoverageTally;
using accuracy::Surfaces;

constexpr Surfaces all_surfaces[] = {Surfaces::all, Surfaces::objects, Surfaces::triangles};

std::string words_of(Surfaces surfaces) {
  if (surfaces == Surfaces::all) return "outlines";
  return surfaces == Surfaces::objects ? "edges of objects" : "edges of triangles";
}

// On a terminal, a line every two seconds of how far the picture is.
class PatientProgress {
 public:
  void tell(std::int64_t frame, int done, int all) {
    const auto now = Clock::now();
    if (done == all || now - told_ < std::chrono::seconds(2) || !stderr_is_terminal()) return;
    told_ = now;
    print_progress(fmt::format("frame {}: {} %", frame, 100 * done / all));
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point told_ = Clock::now();
};

// Of a frame, or of all.
void print_table(const CoverageError& error) {
  const auto number = [](double value) { return fmt::format("{:.3g}", value); };
  const auto pixels = [](double value) { return fmt::format("{:+.4f}", value); };
  std::vector<std::vector<std::string>> rows = {{"error of coverage at", "pixels", "samples", "bias", "max", "RMS",
                                                 "beyond 1/255", "shift x", "shift y", "spread"}};
  for (const Surfaces surfaces : all_surfaces)
    for (std::size_t i = 0; i < sample_counts.size(); ++i) {
      const CoverageTally& t = error.tally(surfaces, i);
      if (t.edge_pixels() == 0) continue;
      const auto [x, y] = t.shift();
      rows.push_back({i == 0 ? words_of(surfaces) : "", i == 0 ? fmt::to_string(t.edge_pixels()) : "",
                      fmt::to_string(sample_counts[i]), surfaces == Surfaces::all ? pixels(t.bias()) : "",
                      number(t.largest()), number(t.rms()), fmt::format("{:.1f} %", 100 * t.beyond()), pixels(x),
                      pixels(y), number(t.spread())});
    }
  for (const std::string& line : aligned(rows)) print_result("  " + line);
  std::string strays;
  for (std::size_t i = 0; i < sample_counts.size(); ++i)
    strays += fmt::format("{}{}", i == 0 ? "" : ", ", error.strays[i]);
  print_result(fmt::format("  samples that show a triangle without area in their pixel: {}; exact areas within {:.1g}",
                           strays, error.error_bound));
}

void print_json(const char* type, const CoverageError& error, const Json& what) {
  for (const Surfaces surfaces : all_surfaces)
    for (std::size_t i = 0; i < sample_counts.size(); ++i) {
      const CoverageTally& t = error.tally(surfaces, i);
      const auto [x, y] = t.shift();
      Json line = what;
      line.update({{"truth", "coverage"},
                   {"surfaces", accuracy::name_of(surfaces)},
                   {"samples", sample_counts[i]},
                   {"pixels", error.pixels},
                   {"edge_pixels", t.edge_pixels()},
                   {"max", t.largest()},
                   {"rms", t.rms()},
                   {"beyond", t.beyond()},
                   {"shift_x", x},
                   {"shift_y", y},
                   {"spread", t.spread()},
                   {"strays", error.strays[i]},
                   {"error_bound", error.error_bound}});
      if (surfaces == Surfaces::all) line["bias"] = t.bias();
      print_result(line_of(json_object(type, line)));
    }
}

}  // namespace

int compare_coverage(const CompareOptions& options, const Scene& scene, const std::vector<std::int64_t>& frames) {
  const Scene measured = accuracy::scene_for_coverage(scene);
  const std::string csv_path =
      options.out.empty() ? "" : (std::filesystem::path(options.out) / (scene.name + ".coverage.csv")).string();
  if (!csv_path.empty()) check_can_create(csv_path);
  const Planner planner(measured);
  std::string csv = accuracy::coverage_csv_header();
  std::optional<CoverageError> sum;
  PatientProgress progress;
  accuracy::CoverageWork work;
  work.threads = choose_thread_count(options.device.threads);
  work.stop = &stop_requested();
  for (const std::int64_t frame : frames) {
    const Plan plan = planner.plan(frame);
    work.progress = [&](int done, int all) { progress.tell(frame, done, all); };
    const CoverageError error = accuracy::coverage_error(*plan, work);
    if (options.json) {
      print_json("coverage_error", error, {{"frame", frame}});
    } else {
      print_result(fmt::format("frame {}, {}x{}, samples against exact coverage; {} pixels show something:", frame,
                               error.width, error.height, error.pixels));
      print_table(error);
    }
    csv += accuracy::coverage_csv_lines(error);
    if (sum)
      *sum += error;
    else
      sum = error;
  }
  if (options.json) {
    print_json("range_coverage_error", *sum,
               {{"frames", frames.size()}, {"first", frames.front()}, {"last", frames.back()}});
  } else if (frames.size() > 1) {
    print_result(fmt::format("frames {}, together:", frame_ranges(frames)));
    print_table(*sum);
  }
  if (!csv_path.empty()) write_file_atomically(csv_path, csv);
  return exit_done;
}

}  // namespace morphcl::cli
