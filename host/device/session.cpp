#include "morphcl/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "host/device/build_options.hpp"
#include "host/device/cache_dir.hpp"
#include "host/device/cl_error.hpp"
#include "host/device/device_list.hpp"
#include "host/device/driver_needs.hpp"
#include "host/device/kernel_source.hpp"
#include "host/device/known_kernels.hpp"
#include "host/device/prepare_process.hpp"
#include "host/device/program_cache.hpp"
#include "host/device/self_test.hpp"
#include "host/device/session_access.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t work_group_items = 16;  // of the self-test; the largest of all kernels of the library

// What rounding in another way explains. What is more is an operation that the device does not have (denormals, fused
// products where none were asked for), or relaxed arithmetic: its pictures are recognizably others.
constexpr std::uint64_t max_tolerated_ulp = 4;

struct SourceProgram {
  BuiltProgram built;
  std::string text, more_options;
  std::set<std::string> unstored;  // kernels in use that the cache does not have yet
};

std::string first_line(const std::string& log) {
  const std::size_t begin = log.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return "the build log is empty";
  return log.substr(begin, log.find_first_of("\r\n", begin) - begin);
}

BuiltProgram build_from_source(ProgramCache& cache, const cl::Context& context, const std::string& file,
                               const std::string& text, const std::string& options) {
  try {
    return cache.build(context, text, options);
  } catch (const cl::BuildError& error) {
    const auto logs = error.getBuildLog();
    throw Error(ErrorKind::internal, file,
                fmt::format("{}: {}", cl_code_name(error.err()), first_line(logs.empty() ? "" : logs.front().second)));
  }
}

}  // namespace

struct Session::Impl {
  DeviceInfo info;
  cl::Context context;
  cl::CommandQueue queue;
  std::string build_options;
  EditSource edit_source;
  std::optional<ProgramCache> cache;
  std::optional<KnownKernels> known;  // of the default device alone
  SelfTestResult self_test;
  bool by_pocl = false;
  bool no_cache_wanted = false;
  std::string cache_name;     // for people; "" where there is no folder
  std::string cache_trouble;  // guarded by programs_mutex

  std::atomic<std::size_t> kernels_compiled{0};
  std::mutex programs_mutex;
  using ProgramKey = std::pair<std::string, std::string>;              // file, all build options
  std::map<std::pair<ProgramKey, std::string>, cl::Program> programs;  // by kernel as well
  std::map<ProgramKey, SourceProgram> source_programs;
  std::map<std::string, std::string> texts;  // of the programs' files

  void open(const FoundDevice& chosen, const SessionOptions& options, bool is_default) {
    info = chosen.info;
    context = cl::Context(chosen.device);
    queue = cl::CommandQueue(context, chosen.device);
    build_options = morphcl::build_options(chosen.device, chosen.platform);
    if (const auto items = chosen.device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>(); items < work_group_items)
      throw Error(ErrorKind::no_device, "",
                  fmt::format("device \"{}\" runs work groups of {} items, and {} are needed; use another one, or "
                              "--device reference",
                              info.name, items, work_group_items));
    const auto folder = choose_cache_dir(options.cache_dir);
    if (folder) cache_name = folder->string();
    no_cache_wanted = cache_is_switched_off(options.cache_dir);
    by_pocl = info.platform.starts_with("Portable Computing Language");
    cache.emplace(folder, compiler_identity(chosen.device, chosen.platform),
                  by_pocl ? placed_pocl_cache() : std::nullopt);
    if (is_default) known.emplace(folder);
  }

  std::string text_of(const KernelSource& source) const { return edit_source ? edit_source(source.text) : source.text; }

  // The program to take this kernel from. A cached binary counts only for the kernels that had run when it was made
  // (see ProgramCache); all others come from one program built from source.
  cl::Program program(const KernelSource& source, const std::string& kernel, const std::string& more_options = "") {
    const std::lock_guard lock(programs_mutex);
    if (const cl::Program* found = compiled_program(source, kernel, more_options)) return *found;
    const ProgramKey key{source.file, build_options + more_options};
    ++kernels_compiled;
    SourceProgram& from_source = source_programs[key];
    if (!from_source.built.program()) {
      if (by_pocl) check_linker();
      from_source.text = texts[source.file];
      from_source.more_options = more_options;
      from_source.built = build_from_source(*cache, context, source.file, from_source.text, key.second);
    }
    from_source.unstored.insert(kernel);
    return programs[{key, kernel}] = from_source.built.program;
  }

  // One that was asked for before or that the cache has; null for others. Under programs_mutex.
  const cl::Program* compiled_program(const KernelSource& source, const std::string& kernel,
                                      const std::string& more_options) {
    const ProgramKey key{source.file, build_options + more_options};
    const auto used = programs.find({key, kernel});
    if (used != programs.end()) return &used->second;
    texts[source.file] = text_of(source);
    const std::string& text = texts[source.file];
    const auto cached = cache->load(context, text, key.second, kernel);
    if (!cached) return nullptr;
    note_known(text, more_options, kernel);
    return &programs.emplace(std::pair(key, kernel), *cached).first->second;
  }

  void note_known(const std::string& text, const std::string& more_options, const std::string& kernel) const {
    if (known) known->add(text, more_options, kernel);
  }

  Kernel kernel(const KernelSource& source, const std::string& name, const std::string& more_options = "") {
    const KernelSignature& signature = signature_of(source, name);
    return Kernel(cl::Kernel(program(source, name, more_options), name.c_str()), signature);
  }

  // Each kernel once: where storing failed it will fail again. The lock is not held while the driver makes binaries,
  // which takes PoCL as long as compiling did.
  std::optional<std::pair<ProgramKey, SourceProgram>> take_unstored() {
    const std::lock_guard lock(programs_mutex);
    for (auto& [key, from_source] : source_programs) {
      if (from_source.unstored.empty()) continue;
      const std::pair<ProgramKey, SourceProgram> taken{key, from_source};
      from_source.unstored.clear();
      return taken;
    }
    return std::nullopt;
  }

  struct UsedProgram {
    cl::Program program;
    std::string text, options;
    std::set<std::string> kernels;
  };

  // What the cache has no binary of.
  std::vector<UsedProgram> without_binary() {
    const std::lock_guard lock(programs_mutex);
    std::map<cl_program, UsedProgram> used;
    for (const auto& [key, program] : programs) {
      const auto& [file, options] = key.first;
      if (cache->has_binary(texts[file], options, key.second)) continue;
      UsedProgram& entry = used[program()];
      entry.program = program;
      entry.text = texts[file];
      entry.options = options;
      entry.kernels.insert(key.second);
    }
    std::vector<UsedProgram> list;
    for (auto& [handle, entry] : used) list.push_back(std::move(entry));
    return list;
  }

  void note_cache_trouble(const std::string& reason) {
    const std::lock_guard lock(programs_mutex);
    if (!cache_trouble.empty() || no_cache_wanted) return;
    if (cache_name.empty())
      cache_trouble = "no folder is named for it; set MORPHCL_CACHE_DIR, or HOME";
    else if (!reason.empty())
      cache_trouble = fmt::format("{}: {}; name another folder with MORPHCL_CACHE_DIR", cache_name, reason);
  }

  void run_self_test() {
    const KernelSource& source = kernel_source("self_test");
    const std::string text = text_of(source);
    if (cache->is_known_identical(text, build_options)) return note_known(text, "", self_test_note);
    const Kernel scalar = kernel(source, "self_test_scalar");
    const Kernel vector = kernel(source, "self_test_vector");
    self_test = morphcl::run_self_test(context, queue, scalar, vector);
    if (self_test.max_ulp > max_tolerated_ulp)
      throw Error(
          ErrorKind::no_device, "",
          fmt::format("device \"{}\" computes wrong ({}), so its pictures would be others; use another device, or "
                      "--device reference",
                      info.name, self_test.detail));
    if (self_test.verdict != Verdict::identical) return;
    cache->remember_identical(text, build_options);
    note_known(text, "", self_test_note);
  }
};

Session::Session() : impl_(std::make_unique<Impl>()) {}

// Whoever launched kernels need not have waited for them; PoCL aborts a process that ends while it compiles one.
Session::~Session() {
  try {
    if (impl_->queue()) impl_->queue.finish();
  } catch (const cl::Error&) {
    // A destructor cannot report; nobody waits for these results.
  }
}

struct SessionAccess {
  static Session::Impl& impl(const Session& session) { return *session.impl_; }
  static std::shared_ptr<Session> make() { return std::shared_ptr<Session>(new Session); }
};

std::shared_ptr<Session> open_session(const SessionOptions& options, EditSource edit_source) {
  ensure_process_prepared(options.threads);
  const std::vector<FoundDevice> devices = find_devices(options.cache_dir);
  const FoundDevice& chosen = choose_device(devices, options.device);
  std::shared_ptr<Session> session = SessionAccess::make();
  auto& impl = SessionAccess::impl(*session);
  checked(fmt::format("opening device \"{}\"", chosen.info.name), [&] {
    impl.edit_source = std::move(edit_source);
    impl.open(chosen, options, &chosen == &choose_device(devices, ""));
    impl.run_self_test();
  });
  return session;
}

std::shared_ptr<Session> Session::open(const SessionOptions& options) { return open_session(options, {}); }

const DeviceInfo& Session::info() const { return impl_->info; }
Verdict Session::verdict() const { return impl_->self_test.verdict; }
const std::string& Session::verdict_detail() const { return impl_->self_test.detail; }

const cl::Context& context_of(const Session& session) { return SessionAccess::impl(session).context; }
const cl::CommandQueue& queue_of(const Session& session) { return SessionAccess::impl(session).queue; }

Kernel kernel_of(Session& session, const KernelSource& source, const std::string& kernel_name,
                 const std::string& more_options) {
  return checked(fmt::format("kernel {} of {}", kernel_name, source.file),
                 [&] { return SessionAccess::impl(session).kernel(source, kernel_name, more_options); });
}

std::size_t Session::kernels_compiled() const { return impl_->kernels_compiled; }

std::string Session::cache_trouble() const {
  const std::lock_guard lock(impl_->programs_mutex);
  return impl_->cache_trouble;
}

bool is_compiled(Session& session, const KernelSource& source, const std::string& kernel_name,
                 const std::string& more_options) {
  auto& impl = SessionAccess::impl(session);
  const std::lock_guard lock(impl.programs_mutex);
  return impl.compiled_program(source, kernel_name, more_options) != nullptr;
}

void store_programs(Session& session, const std::atomic<bool>& stop) {
  auto& impl = SessionAccess::impl(session);
  try {
    while (!stop) {
      const auto taken = impl.take_unstored();
      if (!taken) return;
      const auto& [key, from_source] = *taken;
      const std::set<std::string>& kernels = from_source.unstored;
      std::string trouble;
      const bool stored = impl.cache->store(from_source.built, from_source.text, key.second, kernels, &trouble);
      impl.note_cache_trouble(trouble);
      for (const std::string& kernel : kernels)
        if (stored) impl.note_known(from_source.text, from_source.more_options, kernel);
    }
  } catch (const std::exception&) {
    // The next process compiles again; that is all a missing cache entry costs.
  }
}

void store_binaries(Session& session) {
  auto& impl = SessionAccess::impl(session);
  for (const auto& used : impl.without_binary()) {
    std::string trouble;
    impl.cache->store_binary(used.program, used.text, used.options, used.kernels, &trouble);
    impl.note_cache_trouble(trouble);
  }
}

void Session::store_programs() {
  const std::atomic<bool> never = false;
  morphcl::store_programs(*this, never);
}

}  // namespace morphcl
