#include "lab/accuracy/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>

#include "host/device/build_options.hpp"
#include "host/device/session_access.hpp"
#include "lab/accuracy/elementwise.hpp"
#include "morphcl/error.hpp"

namespace morphcl::accuracy {

namespace {

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) {
      const std::size_t colon = line.find(':');
      if (colon != std::string::npos && colon + 2 <= line.size()) return printable(line.substr(colon + 2));
    }
  return "unknown";
}

Machine describe_machine(const Settings& settings, int threads) {
  Machine machine;
  machine.processor = processor_name();
#if defined(__clang__)
  machine.compiler = fmt::format("Clang {}.{}", __clang_major__, __clang_minor__);
#elif defined(__GNUC__)
  machine.compiler = fmt::format("GCC {}.{}", __GNUC__, __GNUC_MINOR__);
#endif
  machine.host_flags = "-ffp-contract=off";
#if defined(__GNUC__) && !defined(__clang__)
  machine.host_flags += " -fno-tree-slp-vectorize";
#endif
  if (has_vectors()) machine.host_flags += ", loops with avx2 and fma";
  if (!settings.session) return machine;
  const DeviceInfo& info = settings.session->info();
  machine.device = printable(info.name);
  machine.driver = printable(info.driver_version);
  machine.platform = printable(info.platform);
  machine.verdict = settings.session->verdict() == Verdict::identical ? "identical" : "tolerant";
  machine.threads = threads;
  const cl::Device device = context_of(*settings.session).getInfo<CL_CONTEXT_DEVICES>().front();
  machine.device_flags = build_options(device, cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()));
  return machine;
}

std::vector<Operation> chosen(const std::vector<std::string>& names) {
  std::vector<Operation> all = all_operations();
  if (names.empty()) return all;
  for (const std::string& name : names) {
    const auto is_it = [&](const Operation& operation) { return operation.about.name == name; };
    if (std::any_of(all.begin(), all.end(), is_it)) continue;
    std::string list;
    for (const Operation& operation : all) list += (list.empty() ? "" : ", ") + operation.about.name;
    throw Error(ErrorKind::usage, "--operation",
                fmt::format("'{}' is no operation of the report; {}", printable(name), list));
  }
  std::erase_if(all, [&](const Operation& operation) {
    return std::find(names.begin(), names.end(), operation.about.name) == names.end();
  });
  return all;
}

}  // namespace

bool Report::digits_confirmed() const {
  return std::all_of(operations.begin(), operations.end(),
                     [](const OperationReport& operation) { return operation.digits_confirmed; });
}

std::vector<std::string> operation_names() {
  std::vector<std::string> names;
  for (const Operation& operation : all_operations()) names.push_back(operation.about.name);
  return names;
}

Report run_report(const Settings& settings, const std::vector<std::string>& names, int threads,
                  const std::function<void(const std::string&, std::size_t, std::size_t)>& progress) {
  const std::vector<Operation> operations = chosen(names);
  Report report{describe_machine(settings, threads), settings, {}};
  for (std::size_t i = 0; i < operations.size(); ++i) {
    progress(operations[i].about.name, i, operations.size());
    report.operations.push_back(operations[i].run(settings));
  }
  return report;
}

}  // namespace morphcl::accuracy
