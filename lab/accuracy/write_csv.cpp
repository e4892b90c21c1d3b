#include <fmt/core.h>

#include "lab/accuracy/write_files.hpp"

namespace morphcl::accuracy {

namespace {

std::string csv_quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::string csv_of(const Report& report) {
  std::string text = "operation,family,variant,ships,place,compared,hash,device_bits";
  for (std::size_t m = 0; m < measure_count; ++m) text += fmt::format(",{}", text_of(static_cast<Measure>(m)).name);
  text += ",timed,level,batch_elements,runs,minimum_ns,median_ns\n";
  for (const OperationReport& operation : report.operations)
    for (const Result& result : operation.results) {
      std::string start =
          fmt::format("{},{},{},{},{},{},{:016x},{}", operation.about.name, result.family, csv_quoted(result.variant),
                      result.ships ? 1 : 0, result.place, result.compared, result.hash, result.device_bits);
      for (std::size_t m = 0; m < measure_count; ++m) start += "," + printed(result.figures[static_cast<Measure>(m)]);
      if (result.timings.empty()) text += start + ",,,,,,\n";
      for (const Timing& t : result.timings)
        text += fmt::format("{},{},{},{},{},{:.4g},{:.4g}\n", start, t.where, t.level, t.elements, t.runs, t.minimum_ns,
                            t.median_ns);
    }
  return text;
}

}  // namespace morphcl::accuracy
