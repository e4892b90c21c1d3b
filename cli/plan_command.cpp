#include "cli/plan_command.hpp"

#include <fmt/core.h>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/explain_method.hpp"
#include "cli/json_object.hpp"
#include "cli/table.hpp"
#include "host/render/auto/first_situation.hpp"
#include "morphcl/error.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/session.hpp"

namespace morphcl::cli {

namespace {

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / 0x1p20; }

// What the default device allocates at once; nothing where there is none, as a plan needs no device.
std::optional<std::size_t> allocation_limit() try {
  prepare_process(0);
  for (const DeviceInfo& device : list_devices())
    if (device.is_cpu) return device.max_allocation;
  return std::nullopt;
} catch (const Error&) {
  return std::nullopt;
}

// Who draws the frames of the shot with --device auto.
struct Drawing {
  Situation first;
  Choice at_once, later;
  std::size_t frames;
  VisibilityMethod method;
};

Drawing drawing_of(const Scene& scene, const Plan& plan) {
  const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  const Situation first = first_situation(*plan, static_cast<std::int64_t>(frames.size()), {});
  Situation later = first;
  later.frames_drawn = 1;
  if (plan->visibility != VisibilityMethod::z_buffer)
    return {first, Choice::reference, Choice::reference, frames.size(), plan->visibility};
  return {first, choose(first), choose(later), frames.size(), plan->visibility};
}

const char* choice_name(Choice choice) {
  switch (choice) {
    case Choice::reference:
      return "reference";
    case Choice::prepare:
      return "by_turns";
    case Choice::wait:
    case Choice::device:
      return "device";
  }
  return "";
}

std::string drawing_words(const Drawing& drawing) {
  if (drawing.method != VisibilityMethod::z_buffer)
    return fmt::format("the reference draws all frames: devices do not know visibility {}", name_of(drawing.method));
  const Situation& first = drawing.first;
  const std::string costs =
      fmt::format("{:.3g} ms a frame by the reference, {:.3g} by the device, which is ready after {:.2g} s{}",
                  1000 * first.reference_frame, 1000 * first.device_frame, first.preparing,
                  first.compiles ? ", most of it for compiling" : "");
  const char* const who = drawing.later == Choice::reference ? "the reference"
                          : drawing.at_once == Choice::wait  ? "the device"
                          : drawing.later == Choice::wait    ? "the reference the first one, then the device"
                                                             : "the reference until the device is ready";
  return fmt::format("with --device auto {} frame{} drawn by {} (about {})", drawing.frames,
                     drawing.frames == 1 ? " is" : "s are", who, costs);
}

void print_json(const PlanReport& report, const std::string& exceeded, const Drawing& drawing) {
  for (const PlanNote& note : report.notes)
    print_result(line_of(json_object("plan", {{"frame", report.plan.frame()},
                                              {"item", note.item},
                                              {"done", note.done},
                                              {"reason", note.reason},
                                              {"estimated_ms", note.milliseconds},
                                              {"share", note.milliseconds / report.milliseconds}})));
  print_result(line_of(json_object("plan_total", {{"frame", report.plan.frame()},
                                                  {"estimated_ms", report.milliseconds},
                                                  {"mesh_bytes", report.memory.meshes},
                                                  {"vertex_bytes", report.memory.vertices},
                                                  {"bin_bytes", report.memory.bins},
                                                  {"pixel_bytes", report.memory.pixels},
                                                  {"exceeds_device", exceeded},
                                                  {"drawn_by", choice_name(drawing.later)},
                                                  {"first_drawn_by", choice_name(drawing.at_once)},
                                                  {"reference_ms", 1000 * drawing.first.reference_frame},
                                                  {"device_ms", 1000 * drawing.first.device_frame},
                                                  {"preparing_seconds", drawing.first.preparing},
                                                  {"compiles", drawing.first.compiles}})));
}

void print_table(const Scene& scene, const PlanReport& report, const std::string& exceeded, const Drawing& drawing) {
  print_result(fmt::format("{} frame {}, {}x{}: about {:.2f} ms to draw (an estimate; shares are of it)",
                           printable(scene.name), report.plan.frame(), report.plan.width(), report.plan.height(),
                           report.milliseconds));
  std::vector<std::vector<std::string>> rows;
  for (const PlanNote& note : report.notes) {
    const bool counts = note.milliseconds >= 0.0005;
    rows.push_back({note.item, note.done ? "done" : "left out",
                    counts ? fmt::format("{}{:.3f} ms", note.done ? "" : "-", note.milliseconds) : "",
                    counts ? fmt::format("{:.0f} %", 100 * note.milliseconds / report.milliseconds) : "",
                    printable(note.reason)});
  }
  for (const std::string& line : aligned(rows)) print_result(line);
  const MemoryNeed& need = report.memory;
  print_result(
      fmt::format("memory: device {:.1f} MiB (meshes {:.1f}, vertices {:.1f}, bins {:.1f}), host {:.1f} MiB of "
                  "pixels a frame in flight",
                  mebibytes(need.device()), mebibytes(need.meshes), mebibytes(need.vertices), mebibytes(need.bins),
                  mebibytes(need.pixels)));
  if (!exceeded.empty()) print_result("too large: " + exceeded);
  print_result(drawing_words(drawing));
}

}  // namespace

int plan_command(const PlanOptions& options) {
  const Scene scene = open_scene(options.scene);
  const std::int64_t frame = options.frame ? *options.frame : frame_numbers(scene.frames).front();
  const morphcl::PlanOptions what{.leave_out = options.leave_out};
  const Planner planner(scene, what);
  const PlanReport report = explain(planner, frame);
  const std::optional<std::size_t> limit = allocation_limit();
  const Drawing drawing = drawing_of(scene, report.plan);
  const std::string exceeded = limit ? exceeded_limit(report.memory, *limit) : "";
  if (options.json)
    print_json(report, exceeded, drawing);
  else
    print_table(scene, report, exceeded, drawing);
  if (!options.explain.empty()) explain_method(planner, frame, options.explain, options.json);
  return exit_done;
}

}  // namespace morphcl::cli
