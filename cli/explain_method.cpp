#include "cli/explain_method.hpp"

#include <fmt/format.h>

#include "cli/console.hpp"
#include "cli/json_object.hpp"
#include "lab/hidden_surfaces/explain_visibility.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

void explain_method(const Planner& planner, std::int64_t frame, const std::string& folder, bool json) {
  const auto [files, counts, lines] = hidden_surfaces::explain_visibility(planner.plan(frame), folder);
  if (json) {
    Json fields = {{"frame", frame}, {"visibility", name_of(planner.scene().image.visibility)}};
    for (const auto& [name, count] : counts) fields["counts"][name] = count;
    fields["folder"] = folder;
    fields["files"] = files;
    return print_result(line_of(json_object("explanation", fields)));
  }
  for (const std::string& line : lines) print_result(line);
  print_result(fmt::format("written to {}: {}", printable(folder), fmt::join(files, ", ")));
}

}  // namespace morphcl::cli
