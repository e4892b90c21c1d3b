#include "cli/devices_command.hpp"

#include <fmt/core.h>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/json_object.hpp"
#include "cli/stop_signals.hpp"
#include "cli/table.hpp"
#include "morphcl/error.hpp"
#include "morphcl/session.hpp"

namespace morphcl::cli {

namespace {
// "identical", "tolerant: ...", or "unusable: ..." when the device cannot be opened at all.
std::string verdict_text(const DeviceInfo& device, int threads) {
  try {
    SessionOptions options;
    options.device = std::to_string(device.index);
    options.threads = threads;
    const auto session = Session::open(options);
    session->store_programs();
    if (session->verdict() == Verdict::identical) return "identical";
    return "tolerant: " + session->verdict_detail();
  } catch (const Error& error) {
    return "unusable: " + error.message();
  }
}

std::string mebibyte_text(std::size_t bytes) { return fmt::format("{} MiB", bytes >> 20); }

void print_json(const DeviceInfo& device, const std::string& verdict) {
  print_result(line_of(json_object("device", {{"index", device.index},
                                              {"name", device.name},
                                              {"vendor", device.vendor},
                                              {"platform", device.platform},
                                              {"driver_version", device.driver_version},
                                              {"cpu", device.is_cpu},
                                              {"compute_units", device.compute_units},
                                              {"fp64", device.fp64},
                                              {"global_memory_bytes", device.global_memory},
                                              {"largest_allocation_bytes", device.max_allocation},
                                              {"local_memory_bytes", device.local_memory},
                                              {"verdict", verdict}})));
}
}  // namespace

int devices_command(const DevicesOptions& options) {
  watch_driver_aborts();
  const int threads = prepare_process(options.threads);
  std::vector<std::vector<std::string>> rows = {
      {"INDEX", "DEVICE", "PLATFORM", "UNITS", "MEMORY", "LARGEST", "LOCAL", "SELF-TEST"}};
  for (const DeviceInfo& device : list_devices()) {
    const std::string verdict = verdict_text(device, threads);
    if (options.json) print_json(device, verdict);
    rows.push_back({std::to_string(device.index), printable(device.name),
                    printable(device.platform.substr(0, device.platform.find(','))),
                    std::to_string(device.compute_units), mebibyte_text(device.global_memory),
                    mebibyte_text(device.max_allocation), fmt::format("{} KiB", device.local_memory >> 10), verdict});
  }
  if (!options.json)
    for (const std::string& line : aligned(rows)) print_result(line);
  return exit_done;
}

}  // namespace morphcl::cli
