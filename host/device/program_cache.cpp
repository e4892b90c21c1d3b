#include "host/device/program_cache.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>

#include "host/device/program_files.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view verdict_identical = "identical";

// The lines on the model and features of the first processor; "flags" is the name on x86, "Features" on Arm.
std::string processor_description() {
  std::ifstream file("/proc/cpuinfo");
  std::string description;
  for (std::string line; std::getline(file, line) && !line.empty();)
    for (const char* field : {"model name", "flags", "Features", "CPU implementer", "CPU part", "isa"})
      if (line.starts_with(field)) description += line + '\n';
  return description;
}

// PoCL's variables select among other things the kernel library and the vectoriser. Those that cannot change code are
// left out, so that a run on one thread finds what a run on two has stored.
std::vector<std::string> pocl_variables() {
  constexpr std::string_view harmless[] = {
      "POCL_CACHE_DIR=", "POCL_MAX_PTHREAD_COUNT=", "POCL_CPU_MAX_CU_COUNT=", "POCL_DEBUG="};
  std::vector<std::string> variables;
  for (char** variable = environ; variable && *variable; ++variable) {
    const std::string_view text = *variable;
    if (text.starts_with("POCL_") && std::none_of(std::begin(harmless), std::end(harmless),
                                                  [&](std::string_view name) { return text.starts_with(name); }))
      variables.emplace_back(text);
  }
  std::sort(variables.begin(), variables.end());
  return variables;
}

std::optional<fs::path> subfolder(const std::optional<fs::path>& cache_dir, const char* name) {
  return cache_dir ? std::optional(*cache_dir / name) : std::nullopt;
}

std::string identity_of(const std::vector<unsigned char>& bytes) {
  return cache_key(std::array{std::string(bytes.begin(), bytes.end())}).hex();
}

std::string program_identity(const std::string& source, const std::string& options) {
  return cache_key(std::array{source, options}).hex();
}

std::span<const unsigned char> bytes_of(std::string_view text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

}  // namespace

std::vector<std::string> machine_identity() {
  std::vector<std::string> identity = {processor_description()};
  const std::vector<std::string> variables = pocl_variables();
  identity.insert(identity.end(), variables.begin(), variables.end());
  return identity;
}

std::vector<std::string> compiler_identity(const cl::Device& device, const cl::Platform& platform) {
  std::vector<std::string> identity = {device.getInfo<CL_DEVICE_NAME>(),     device.getInfo<CL_DEVICE_VENDOR>(),
                                       device.getInfo<CL_DEVICE_VERSION>(),  device.getInfo<CL_DRIVER_VERSION>(),
                                       platform.getInfo<CL_PLATFORM_NAME>(), platform.getInfo<CL_PLATFORM_VERSION>()};
  const std::vector<std::string> machine = machine_identity();
  identity.insert(identity.end(), machine.begin(), machine.end());
  return identity;
}

ProgramCache::ProgramCache(const std::optional<fs::path>& cache_dir, std::vector<std::string> identity,
                           std::optional<fs::path> pocl_folder)
    : compiler_identity_(std::move(identity)),
      pocl_folder_(std::move(pocl_folder)),
      binaries_(subfolder(cache_dir, "programs"), "clbin"),
      files_(subfolder(cache_dir, "programs"), "clfiles"),
      verdicts_(subfolder(cache_dir, "programs"), "verdict") {}

CacheKey ProgramCache::key(const std::string& source, const std::string& options, const std::string& name) const {
  std::vector<std::string> parts = compiler_identity_;
  parts.insert(parts.end(), {options, source, name});
  return cache_key(parts);
}

std::optional<cl::Program> ProgramCache::load(const cl::Context& context, const std::string& source,
                                              const std::string& options, const std::string& kernel) {
  const CacheKey key = this->key(source, options, kernel);
  if (const auto program = load_binary(context, key, options)) return program;
  return load_files(context, key, source, options);
}

std::optional<cl::Program> ProgramCache::load_binary(const cl::Context& context, const CacheKey& key,
                                                     const std::string& options) {
  auto binary = binaries_.load(key);
  if (!binary) return std::nullopt;
  const std::string identity = identity_of(*binary);
  if (const auto loaded = loaded_.find(identity); loaded != loaded_.end()) return loaded->second;
  try {
    cl::Program program(context, context.getInfo<CL_CONTEXT_DEVICES>(), cl::Program::Binaries{std::move(*binary)});
    program.build(options.c_str());
    return loaded_[identity] = program;
  } catch (const cl::Error&) {
    return std::nullopt;
  }
}

std::optional<cl::Program> ProgramCache::load_files(const cl::Context& context, const CacheKey& key,
                                                    const std::string& source, const std::string& options) {
  if (!pocl_folder_) return std::nullopt;
  const auto files = files_.load(key);
  if (!files) return std::nullopt;
  const std::string identity = identity_of(*files);
  if (const auto loaded = loaded_.find(identity); loaded != loaded_.end()) return loaded->second;
  const auto folder = unpack_program_files(*pocl_folder_, *files);
  if (!folder) return std::nullopt;
  folders_[program_identity(source, options)] = *folder;
  try {
    return loaded_[identity] = build(context, source, options).program;
  } catch (const cl::Error&) {
    return std::nullopt;
  }
}

bool ProgramCache::has_binary(const std::string& source, const std::string& options, const std::string& kernel) const {
  return binaries_.load(key(source, options, kernel)).has_value();
}

BuiltProgram ProgramCache::build(const cl::Context& context, const std::string& source, const std::string& options) {
  std::set<fs::path> before, added;
  if (pocl_folder_) before = program_folders(*pocl_folder_);
  BuiltProgram built{cl::Program(context, source), {}};
  built.program.build(options.c_str());
  if (!pocl_folder_) return built;
  const std::set<fs::path> after = program_folders(*pocl_folder_);
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::inserter(added, added.end()));
  fs::path& folder = folders_[program_identity(source, options)];
  if (added.size() == 1) folder = *added.begin();  // of more, another session's thread has added one
  built.files = folder;
  return built;
}

bool ProgramCache::store(const BuiltProgram& built, const std::string& source, const std::string& options,
                         const std::set<std::string>& kernels, std::string* trouble) const {
  if (!files_.has_folder() || kernels.empty()) return false;
  const auto files =
      pocl_folder_ && !built.files.empty() ? pack_program_files(*pocl_folder_, built.files, kernels) : std::nullopt;
  if (!files) return store_binary(built.program, source, options, kernels, trouble);
  return std::all_of(kernels.begin(), kernels.end(), [&](const std::string& kernel) {
    return files_.store(key(source, options, kernel), *files, trouble);
  });
}

bool ProgramCache::store_binary(const cl::Program& program, const std::string& source, const std::string& options,
                                const std::set<std::string>& kernels, std::string* trouble) const {
  // Not asked in vain: PoCL compiles all kernels once more for a binary.
  if (!binaries_.has_folder() || kernels.empty()) return false;
  try {
    const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    if (binaries.size() != 1 || binaries.front().empty()) return false;
    return std::all_of(kernels.begin(), kernels.end(), [&](const std::string& kernel) {
      return binaries_.store(key(source, options, kernel), binaries.front(), trouble);
    });
  } catch (const cl::Error&) {
    return false;
  }
}

bool ProgramCache::is_known_identical(const std::string& self_test_source, const std::string& options) const {
  const auto content = verdicts_.load(key(self_test_source, options, "verdict"));
  const auto expected = bytes_of(verdict_identical);
  return content && std::equal(content->begin(), content->end(), expected.begin(), expected.end());
}

void ProgramCache::remember_identical(const std::string& self_test_source, const std::string& options) const {
  verdicts_.store(key(self_test_source, options, "verdict"), bytes_of(verdict_identical));
}

}  // namespace morphcl
