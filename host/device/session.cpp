#include "host/device/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "host/device/build_options.hpp"
#include "host/device/cl_error.hpp"
#include "host/device/device_list.hpp"
#include "host/device/kernel_source.hpp"
#include "host/device/prepare_process.hpp"
#include "host/error.hpp"

namespace morphcl {

namespace {

struct BuiltProgram {
  cl::Program program;
  bool from_source = false;
};

const std::string& source_of(const std::string& stage) {
  const auto& sources = kernel_sources();
  const auto source = std::find_if(sources.begin(), sources.end(), [&](const auto& s) { return s.stage == stage; });
  if (source == sources.end())
    throw Error(ErrorKind::internal, "", fmt::format("no kernel program \"{}\" is embedded in this build", stage));
  return source->text;
}

std::string first_line(const std::string& log) {
  const std::size_t begin = log.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return "the build log is empty";
  return log.substr(begin, log.find_first_of("\r\n", begin) - begin);
}

cl::Program build_from_source(const cl::Context& context, const std::string& stage, const std::string& options) {
  cl::Program program(context, source_of(stage));
  try {
    program.build(options.c_str());
  } catch (const cl::BuildError& error) {
    const auto logs = error.getBuildLog();
    throw Error(ErrorKind::internal, "kernels/" + stage + ".cl",
                fmt::format("{}: {}", cl_code_name(error.err()), first_line(logs.empty() ? "" : logs.front().second)));
  }
  return program;
}

}  // namespace

struct Session::Impl {
  DeviceInfo info;
  cl::Device device;
  cl::Context context;
  cl::CommandQueue queue;
  std::string build_options;
  Verdict verdict = Verdict::identical;
  std::string verdict_detail;

  std::mutex programs_mutex;
  std::map<std::string, BuiltProgram> programs;

  const cl::Program& program(const std::string& stage) {
    const std::lock_guard lock(programs_mutex);
    auto built = programs.find(stage);
    if (built == programs.end())
      built = programs.emplace(stage, BuiltProgram{build_from_source(context, stage, build_options), true}).first;
    return built->second.program;
  }
};

Session::Session() : impl_(std::make_unique<Impl>()) {}
Session::~Session() = default;

std::shared_ptr<Session> Session::open(const SessionOptions& options) {
  ensure_process_prepared(options.threads);
  const std::vector<FoundDevice> devices = find_devices();
  const FoundDevice& chosen = choose_device(devices, options.device);
  std::shared_ptr<Session> session(new Session);
  Impl& impl = *session->impl_;
  impl.info = chosen.info;
  impl.device = chosen.device;
  checked(fmt::format("opening device \"{}\"", chosen.info.name), [&] {
    impl.context = cl::Context(impl.device);
    impl.queue = cl::CommandQueue(impl.context, impl.device);
    impl.build_options = build_options(chosen.device, chosen.platform);
  });
  return session;
}

const DeviceInfo& Session::info() const { return impl_->info; }
Verdict Session::verdict() const { return impl_->verdict; }
const std::string& Session::verdict_detail() const { return impl_->verdict_detail; }
const cl::Context& Session::context() const { return impl_->context; }
const cl::CommandQueue& Session::queue() const { return impl_->queue; }

cl::Kernel Session::kernel(const std::string& stage, const std::string& kernel_name) {
  return checked(fmt::format("kernel {} of kernels/{}.cl", kernel_name, stage),
                 [&] { return cl::Kernel(impl_->program(stage), kernel_name.c_str()); });
}

void Session::store_programs() {}

}  // namespace morphcl
