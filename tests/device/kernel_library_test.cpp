// PoCL's kernel libraries stand in for several kinds of processor: all must give the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/device/child_process.hpp"
#include "tests/device/temporary_folder.hpp"

namespace morphcl::testing {
namespace {

struct Library {
  const char* name;
  std::vector<std::string> needs;  // as /proc/cpuinfo calls them
};

const std::vector<Library> libraries = {
    {"sse2", {"sse2"}},
    {"ssse3", {"ssse3"}},
    {"sse41", {"sse4_1"}},
    {"avx", {"avx"}},
    {"avx_f16c", {"avx", "f16c"}},
    {"avx2", {"avx2", "fma"}},
    {"avx512", {"avx512f", "avx512bw", "avx512dq", "avx512vl", "avx512cd"}},
};

std::vector<std::string> processor_features() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("flags")) {
      std::istringstream words(line);
      std::vector<std::string> features;
      for (std::string word; words >> word;) features.push_back(word);
      return features;
    }
  return {};
}

bool runs_here(const Library& library, const std::vector<std::string>& features) {
  return std::all_of(library.needs.begin(), library.needs.end(), [&](const std::string& need) {
    return std::find(features.begin(), features.end(), need) != features.end();
  });
}

TEST(KernelLibraries, GiveTheSameBits) {
  const std::vector<std::string> command = {"transform", "5000", "33"};
  const auto hash = [&](const char* library) {
    const TemporaryFolder cache;  // whether PoCL tells libraries apart in its cache is not documented
    Environment environment = {{"MORPHCL_CACHE_DIR", "-"}, {"POCL_CACHE_DIR", cache.path().string()}};
    if (library) environment["POCL_KERNELLIB_NAME"] = library;
    const ChildResult result = run_device_child(command, environment);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return result.value("hash");
  };
  const std::string native = hash(nullptr);
  ASSERT_NE(native, "");
  const auto features = processor_features();
  for (const Library& library : libraries) {
    if (!runs_here(library, features)) continue;
    EXPECT_EQ(hash(library.name), native) << library.name;
  }
}

}  // namespace
}  // namespace morphcl::testing
