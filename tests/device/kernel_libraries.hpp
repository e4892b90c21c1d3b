// PoCL's kernel libraries, which stand in for several kinds of processor.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace morphcl::testing {

// scripts/long asks for what takes minutes more.
inline bool long_tests() { return std::getenv("MORPHCL_LONG_TESTS") != nullptr; }

// Values of POCL_KERNELLIB_NAME whose instructions this processor has. Each takes half a minute of compiling: those
// whose arithmetic instructions the next one has as well are left out, but in long_tests().
inline std::vector<std::string> kernel_libraries_that_run_here() {
  struct Library {
    const char* name;
    bool always;
    std::vector<std::string> needs;  // as /proc/cpuinfo calls them
  };
  const std::vector<Library> libraries = {
      {"sse2", true, {"sse2"}},
      {"ssse3", false, {"ssse3"}},
      {"sse41", false, {"sse4_1"}},
      {"avx", false, {"avx"}},
      {"avx_f16c", true, {"avx", "f16c"}},  // rounds to half and to whole numbers by instructions
      {"avx2", true, {"avx2", "fma"}},
      {"avx512", true, {"avx512f", "avx512bw", "avx512dq", "avx512vl", "avx512cd"}},
  };
  std::vector<std::string> features;
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; features.empty() && std::getline(file, line);)
    if (line.starts_with("flags")) {
      std::istringstream words(line);
      for (std::string word; words >> word;) features.push_back(word);
    }
  std::vector<std::string> names;
  for (const Library& library : libraries)
    if ((long_tests() || library.always) &&
        std::all_of(library.needs.begin(), library.needs.end(), [&](const std::string& need) {
          return std::find(features.begin(), features.end(), need) != features.end();
        }))
      names.push_back(library.name);
  return names;
}

}  // namespace morphcl::testing
