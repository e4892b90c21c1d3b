#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "lab/accuracy/verdict.hpp"
#include "lab/accuracy/write_files.hpp"

namespace morphcl::accuracy {

namespace {

using Json = nlohmann::ordered_json;

// Infinite figures have no number in JSON; they are strings.
Json number(double value) {
  if (value - value == 0) return std::stod(printed(value));
  return value == value ? Json(value > 0 ? "inf" : "-inf") : Json(nullptr);
}

Json json_figures(const Figures& figures) {
  Json json = Json::object();
  for (std::size_t m = 0; m < measure_count; ++m) {
    const auto measure = static_cast<Measure>(m);
    if (figures.has(measure)) json[text_of(measure).name] = number(figures[measure]);
  }
  return json;
}

Json json_result(const Result& result) {
  Json json = {{"family", result.family}, {"variant", result.variant},   {"ships", result.ships},
               {"place", result.place},   {"compared", result.compared}, {"hash", fmt::format("{:016x}", result.hash)}};
  if (result.c_library) json["c_library"] = true;
  if (!result.device_bits.empty()) json["device_bits"] = result.device_bits;
  json["errors"] = json_figures(result.figures);
  json["timings"] = Json::array();
  for (const Timing& t : result.timings)
    json["timings"].push_back({{"where", t.where},
                               {"level", t.level},
                               {"elements", t.elements},
                               {"runs", t.runs},
                               {"minimum_ns", t.minimum_ns},
                               {"median_ns", t.median_ns}});
  return json;
}

Json json_operation(const OperationReport& operation) {
  const Description& about = operation.about;
  Json json = {{"schema", 1},
               {"type", "operation"},
               {"operation", about.name},
               {"title", about.title},
               {"unit", about.results},
               {"ulp_bits", about.format.bits},
               {"target_measure", text_of(about.plotted).name},
               {"target", about.target},
               {"target_reason", about.reason},
               {"digits_confirmed", operation.digits_confirmed}};
  json["families"] = Json::array();
  for (const Family& family : operation.families)
    json["families"].push_back(
        {{"family", family.name}, {"inputs", family.text}, {"verdict", verdict(operation, family.name)}});
  json["results"] = Json::array();
  for (const Result& result : operation.results) json["results"].push_back(json_result(result));
  return json;
}

}  // namespace

std::string json_of(const OperationReport& operation) {
  return json_operation(operation).dump(-1, ' ', false, Json::error_handler_t::replace);
}

namespace {

Json json_head(const Report& report) {
  const Machine& m = report.machine;
  Json json = {{"schema", 1},
               {"type", "accuracy"},
               {"quick", report.settings.quick},
               {"seed", report.settings.seed},
               {"reference_bits", wide_bits},
               {"confirming_bits", doubled_bits},
               {"digits_confirmed", report.digits_confirmed()}};
  json["machine"] = {
      {"processor", m.processor}, {"compiler", m.compiler}, {"flags", m.host_flags},  {"device", m.device},
      {"driver", m.driver},       {"platform", m.platform}, {"self_test", m.verdict}, {"device_flags", m.device_flags},
      {"threads", m.threads}};
  return json;
}

}  // namespace

std::string json_line_of(const Report& report) {
  return json_head(report).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string json_of(const Report& report) {
  Json json = json_head(report);
  json["operations"] = Json::array();
  for (const OperationReport& operation : report.operations) json["operations"].push_back(json_operation(operation));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace morphcl::accuracy
