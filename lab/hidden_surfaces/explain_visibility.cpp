#include "lab/hidden_surfaces/explain_visibility.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "host/image/atomic_file.hpp"
#include "lab/hidden_surfaces/method_lists.hpp"
#include "lab/hidden_surfaces/method_pictures.hpp"

namespace morphcl::hidden_surfaces {

Explanation explain_visibility(const Plan& plan, const std::string& folder) {
  const MethodRun run(plan);
  Explanation explanation;
  const std::string stem = fmt::format("{}.{:04}.", name_of(run.method()), plan.frame());
  const auto path = [&](const char* name) {
    explanation.files.push_back(stem + name);
    return (std::filesystem::path(folder) / (stem + name)).string();
  };
  const auto text = [&](const char* name, const std::string& content) { write_file_atomically(path(name), content); };
  text("numbers.json", numbers_json(run));
  write_png(path("overdraw.png"), overdraw_picture(run));
  switch (run.method()) {
    case VisibilityMethod::bsp:
      text("tree.txt", tree_text(run));
      text("tree.dot", tree_dot(run));
      [[fallthrough]];
    case VisibilityMethod::painter:
      text("order.csv", order_csv(run));
      write_png(path("order.png"), order_picture(run));
      break;
    case VisibilityMethod::warnock:
      text("windows.csv", windows_csv(run));
      write_png(path("quadtree.png"), quadtree_picture(run));
      break;
    case VisibilityMethod::watkins:
      text("spans.csv", spans_csv(run));
      write_png(path("spans.png"), spans_picture(run));
      break;
    case VisibilityMethod::z_buffer:
      break;
  }
  if (run.method() != VisibilityMethod::z_buffer) text("within_error.csv", within_error_csv(run));
  explanation.counts = run.counts;
  explanation.lines.push_back(fmt::format("{} frame {}: {:.3f} s", name_of(run.method()), plan.frame(), run.seconds));
  for (const auto& [name, count] : run.counts) explanation.lines.push_back(fmt::format("{:>12}  {}", count, name));
  return explanation;
}

}  // namespace morphcl::hidden_surfaces
