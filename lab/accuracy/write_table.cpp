#include "lab/accuracy/write_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "lab/accuracy/text_rows.hpp"
#include "lab/accuracy/verdict.hpp"

namespace morphcl::accuracy {

namespace {

constexpr Measure table_columns[] = {Measure::max_ulp,      Measure::rms_ulp,    Measure::max_scaled,
                                     Measure::max_absolute, Measure::max_true,   Measure::max_pixels,
                                     Measure::wrong,        Measure::holes,      Measure::double_hits,
                                     Measure::ties,         Measure::inversions, Measure::not_finite};

std::string short_figure(double value) { return value == value ? fmt::format("{:.2g}", value) : ""; }

// Some columns say nothing new in a family: all 0.
bool always_zero(const OperationReport& report, Measure measure) {
  return std::all_of(report.results.begin(), report.results.end(),
                     [&](const Result& result) { return !(result.figures[measure] > 0); });
}

TextRow heading_row(const OperationReport& report) {
  TextRow row = {"variant"};
  for (const Measure measure : table_columns)
    row.push_back(always_zero(report, measure) && measure != report.about.plotted ? "" : text_of(measure).title);
  row.push_back("ns");
  return row;
}

TextRow cells(const OperationReport& report, const Result& result) {
  std::string name = (result.ships ? "* " : "  ") + result.variant;
  if (result.place == "device") name += " (device)";
  TextRow row = {name};
  for (const Measure measure : table_columns)
    row.push_back(
        always_zero(report, measure) && measure != report.about.plotted ? "" : short_figure(result.figures[measure]));
  row.push_back(result.timings.empty() ? "" : fmt::format("{:.3g}", result.timings.front().minimum_ns));
  return row;
}

std::string batch_of(const Timing& timing) {
  const std::size_t n = timing.elements;
  const std::string size = n >= 1 << 20   ? fmt::format("{}M", n >> 20)
                           : n >= 1 << 10 ? fmt::format("{}k", n >> 10)
                                          : fmt::format("{}", n);
  return size + " " + (timing.where == "host" ? timing.level : timing.where == "device" ? "device" : "+copy");
}

// The first digits of the results' hash, whether the device has the same, and the median times for every batch that was
// timed.
std::string batches_of(const OperationReport& report, const std::string& family) {
  TextRow batches = {"variant", "hash", "device"};
  for (const Result& result : report.results)
    for (const Timing& timing : result.timings)
      if (result.family == family && std::find(batches.begin(), batches.end(), batch_of(timing)) == batches.end())
        batches.push_back(batch_of(timing));
  std::vector<TextRow> rows = {batches};
  for (const Result& result : report.results) {
    if (result.family != family) continue;
    TextRow row = {"  " + result.variant, fmt::format("{:016x}", result.hash).substr(0, 8), result.device_bits};
    row.resize(batches.size());
    for (const Timing& timing : result.timings) {
      const auto column = std::find(batches.begin(), batches.end(), batch_of(timing)) - batches.begin();
      row[static_cast<std::size_t>(column)] = fmt::format("{:.3g}", timing.median_ns);
    }
    rows.push_back(std::move(row));
  }
  return aligned(rows);
}

}  // namespace

std::string machine_text(const Report& report) {
  const Machine& m = report.machine;
  std::string text = fmt::format("host: {}, {}, {}, 1 thread\n", m.processor, m.compiler, m.host_flags);
  if (m.device.empty())
    text += "device: none\n";
  else
    text += fmt::format("device: {} ({}), self-test {}, {} threads, {}\n", m.device, m.driver, m.verdict, m.threads,
                        m.device_flags);
  return text + fmt::format("seed {}\n", report.settings.seed);
}

std::string table_of(const OperationReport& report) {
  const Description& about = report.about;
  std::string text = fmt::format("{}: {}\n  target: {} {} ({})\n", about.name, about.title,
                                 text_of(about.plotted).title, printed(about.target), about.reason);
  for (const Family& family : report.families) {
    text += fmt::format("\n  {}: {}\n", family.name, family.text);
    std::vector<TextRow> rows = {heading_row(report)};
    for (const Result& result : report.results)
      if (result.family == family.name) rows.push_back(cells(report, result));
    text += aligned(rows) + "  -> " + verdict(report, family.name) + "\n";
    text += "  batches (elements), median ns an element:\n" + batches_of(report, family.name);
  }
  return text;
}

}  // namespace morphcl::accuracy
