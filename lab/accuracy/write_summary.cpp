#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "lab/accuracy/text_rows.hpp"
#include "lab/accuracy/write_table.hpp"

namespace morphcl::accuracy {

namespace {

// A variant over all families of inputs.
struct Overall {
  std::string variant;
  double error = 0;         // the largest
  bool finite = true;       // all results
  double nanoseconds = 0;   // for the first family
  std::string beyond = {};  // families in which it is over the bound
};

Overall overall(const OperationReport& report, const std::string& variant) {
  Overall all{variant};
  for (const Result& result : report.results) {
    if (result.variant != variant) continue;
    const double error = result.figures[report.about.plotted];
    const bool finite = error - error == 0 && !(result.figures[Measure::not_finite] > 0);
    all.finite = all.finite && finite;
    if (finite) all.error = std::max(all.error, error);
    if (!(error <= report.about.target)) all.beyond += (all.beyond.empty() ? "" : ", ") + result.family;
    if (all.nanoseconds == 0 && !result.timings.empty()) all.nanoseconds = result.timings.front().minimum_ns;
  }
  return all;
}

std::string error_text(const Overall& all) { return all.finite ? fmt::format("{:.2g}", all.error) : "NaN/inf"; }

std::string time_text(const Overall& all) { return all.nanoseconds > 0 ? fmt::format("{:.3g}", all.nanoseconds) : ""; }

}  // namespace

std::string summary_of(const Report& report) {
  std::vector<TextRow> rows = {
      {"operation", "unit", "morphcl", "", "bound", "ns", "naive", "ns", "the form that comes to mind first"}};
  std::string beyond;
  for (const OperationReport& operation : report.operations) {
    if (operation.results.empty()) continue;
    const auto ships = std::find_if(operation.results.begin(), operation.results.end(),
                                    [](const Result& result) { return result.ships; });
    const Result& first = operation.results.front();  // the form that one would write first, where it is another one
    TextRow row = {operation.about.name, text_of(operation.about.plotted).title};
    if (ships != operation.results.end()) {
      const Overall ours = overall(operation, ships->variant);
      row.insert(row.end(),
                 {error_text(ours), ours.beyond.empty() ? "" : "!", printed(operation.about.target), time_text(ours)});
      if (!ours.beyond.empty())
        beyond += fmt::format("  ! {}: over the bound for these inputs: {}\n", operation.about.name, ours.beyond);
    }
    row.resize(6);
    if (!first.ships) {
      const Overall naive = overall(operation, first.variant);
      row.insert(row.end(), {error_text(naive), time_text(naive), first.variant});
    }
    row.resize(rows.front().size());
    rows.push_back(std::move(row));
  }
  return aligned(rows, LastColumn::words) + beyond +
         "  errors: the largest over all inputs; ns: the smallest of 30 runs or more, an element of the first inputs\n";
}

}  // namespace morphcl::accuracy
