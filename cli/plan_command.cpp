#include "cli/plan_command.hpp"

#include <fmt/core.h>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/json_line.hpp"
#include "cli/table.hpp"
#include "host/error.hpp"
#include "host/render/plan/report.hpp"
#include "host/scene/frame_range.hpp"

namespace morphcl::cli {

int plan_command(const PlanOptions& options) {
  const Scene scene = open_scene(options.scene);
  const std::int64_t frame = options.frame ? *options.frame : frame_numbers(scene.frames).front();
  const morphcl::PlanOptions what{.leave_out = options.leave_out};
  const PlanReport report = explain(Planner(scene, what), scene, what, frame);
  if (options.json) {
    for (const PlanNote& note : report.notes) {
      JsonLine line("plan");
      line.add("frame", frame).add("item", note.item).add("done", note.done).add("reason", note.reason);
      print_result(line.str());
    }
  } else {
    std::vector<std::vector<std::string>> rows;
    for (const PlanNote& note : report.notes)
      rows.push_back({note.item, note.done ? "done" : "left out", printable(note.reason)});
    print_result(
        fmt::format("{} frame {}, {}x{}", printable(scene.name), frame, report.plan.width, report.plan.height));
    for (const std::string& line : aligned(rows)) print_result(line);
  }
  return exit_done;
}

}  // namespace morphcl::cli
