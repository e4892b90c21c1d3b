#include "cli/accuracy_command.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "cli/console.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_values.hpp"
#include "cli/stop_signals.hpp"
#include "host/image/atomic_file.hpp"
#include "lab/accuracy/report.hpp"
#include "lab/accuracy/write_files.hpp"
#include "lab/accuracy/write_plot.hpp"
#include "lab/accuracy/write_table.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {

namespace fs = std::filesystem;

std::string path_in(const std::string& folder, const char* name) { return (fs::path(folder) / name).string(); }

void write_files(const accuracy::Report& report, const std::string& folder) {
  const auto write = [&](const char* name, const std::string& text) {
    write_file_atomically(path_in(folder, name), std::span<const char>(text.data(), text.size()));
  };
  write("accuracy.csv", accuracy::csv_of(report));
  write("accuracy.json", accuracy::json_of(report));
  const std::string missing = accuracy::draw_plots(report, path_in(folder, "accuracy.svg"));
  if (!missing.empty()) print_message(missing);
}

// "none" runs nothing on a device; without --device a machine that has none is told so and goes on.
std::shared_ptr<Session> open_session(const DeviceOptions& options, int& threads) {
  if (options.device == "none") return nullptr;
  if (options.device == "reference")
    throw Error(ErrorKind::usage, "--device", "the reference renderer is no device; an OpenCL device, or none");
  SessionOptions session;
  session.device = options.device;
  try {
    watch_driver_aborts();
    threads = prepare_process(options.threads);
    session.threads = threads;
    return Session::open(session);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_device || !options.device.empty()) throw;
    print_message(error.message() + "; only the host is measured");
    return nullptr;
  }
}

std::string digits_text(const accuracy::Report& report) {
  const std::string what =
      fmt::format("reference of {} bits, again with {}", accuracy::wide_bits, accuracy::doubled_bits);
  if (report.digits_confirmed()) return what + ": no printed digit changes";
  std::string names;
  for (const accuracy::OperationReport& operation : report.operations)
    if (!operation.digits_confirmed) names += (names.empty() ? "" : ", ") + operation.about.name;
  return what + ": printed digits CHANGE in " + names;
}

}  // namespace

int accuracy_command(const AccuracyOptions& options) {
  if (!options.out.empty()) check_can_create(path_in(options.out, "accuracy.csv"));
  int threads = 0;
  accuracy::Settings settings;
  settings.quick = options.quick;
  settings.seed = parse_seed(options.seed);
  settings.session = open_session(options.device, threads);
  const accuracy::Report report = accuracy::run_report(settings, options.operations, threads,
                                                       [](const std::string& name, std::size_t done, std::size_t all) {
                                                         print_progress(fmt::format("{}/{} {}", done + 1, all, name));
                                                       });
  if (settings.session) settings.session->store_programs();
  if (!options.out.empty()) write_files(report, options.out);
  if (options.json) {
    print_result(accuracy::json_line_of(report));
    for (const accuracy::OperationReport& operation : report.operations) print_result(accuracy::json_of(operation));
  } else {
    print_result(accuracy::machine_text(report));
    print_result(accuracy::summary_of(report));
    if (options.verbose) {
      print_result("* is what morphcl itself computes; ns is the smallest of 30 runs or more an element\n");
      for (const accuracy::OperationReport& operation : report.operations) print_result(accuracy::table_of(operation));
    }
    print_result(digits_text(report));
  }
  if (!report.digits_confirmed())
    throw Error(ErrorKind::internal, "", "the reference has too few digits for some figures of this report");
  return exit_done;
}

}  // namespace morphcl::cli
