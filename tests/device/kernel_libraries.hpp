// PoCL's kernel libraries, which stand in for several kinds of processor.
#pragma once

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace morphcl::testing {

// Values of POCL_KERNELLIB_NAME whose instructions this processor has.
inline std::vector<std::string> kernel_libraries_that_run_here() {
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
  std::vector<std::string> features;
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; features.empty() && std::getline(file, line);)
    if (line.starts_with("flags")) {
      std::istringstream words(line);
      for (std::string word; words >> word;) features.push_back(word);
    }
  std::vector<std::string> names;
  for (const Library& library : libraries)
    if (std::all_of(library.needs.begin(), library.needs.end(), [&](const std::string& need) {
          return std::find(features.begin(), features.end(), need) != features.end();
        }))
      names.push_back(library.name);
  return names;
}

}  // namespace morphcl::testing
