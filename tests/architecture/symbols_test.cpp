// The objects of the library's rooms call no C functions but those of tests/architecture/c_functions.txt, so none whose
// last bit depends on the C library or the processor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::architecture {
namespace {

using test_support::lines_of;
using test_support::ProcessResult;
using test_support::run_process;
using test_support::text_of;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> allowed_functions() {
  std::vector<std::string> patterns;
  for (const std::string& line : lines_of(text_of(MORPHCL_SOURCE_DIR "/tests/architecture/c_functions.txt")))
    if (!line.empty() && line[0] != '#') patterns.push_back(line);
  return patterns;
}

// __memcpy_chk is memcpy, __isoc23_strtoull is strtoull: names of glibc for the same function.
std::string plain_name(std::string name) {
  for (const std::string prefix : {"__isoc23_", "__isoc99_"})
    if (name.starts_with(prefix)) return name.substr(prefix.size());
  if (name.starts_with("__") && name.ends_with("_chk")) return name.substr(2, name.size() - 6);
  return name;
}

// One line a function that is not allowed: "OBJECT calls hypot". Names of C++ are those of the library and of others'
// whose arithmetic is in headers, which end in C functions too.
std::vector<std::string> forbidden_calls(const std::vector<std::string>& objects) {
  std::vector<std::string> command = {MORPHCL_NM, "-A", "-u", "-P"};
  command.insert(command.end(), objects.begin(), objects.end());
  const ProcessResult result = run_process(command);
  if (result.code != 0) throw std::runtime_error("nm: " + result.err);
  const std::vector<std::string> patterns = allowed_functions();
  std::vector<std::string> found;
  for (const std::string& line : result.out_lines()) {  // OBJECT: NAME U
    std::istringstream words(line.substr(line.rfind(": ") + 2));
    std::string name;
    words >> name;
    if (name.starts_with("_Z")) continue;
    name = plain_name(name);
    const auto allows = [&name](const std::string& p) { return fnmatch(p.c_str(), name.c_str(), 0) == 0; };
    if (std::none_of(patterns.begin(), patterns.end(), allows))
      found.push_back(line.substr(0, line.rfind(": ")) + " calls " + name);
  }
  return found;
}

TEST(CFunctions, OfTheLibraryAreThoseThatAreListed) {
  const std::vector<std::string> objects = lines_of(text_of(MORPHCL_OBJECT_LIST));
  ASSERT_GT(objects.size(), 20u);
  EXPECT_THAT(forbidden_calls(objects), IsEmpty());
}

TEST(CFunctions, NotListedAreFoundByNameAndObject) {
  const std::string object = MORPHCL_FORBIDDEN_OBJECT;
  EXPECT_THAT(forbidden_calls({object}), ElementsAre(object + " calls hypot"));
}

TEST(CFunctions, ListedHaveNoneThatIsNotCorrectlyRounded) {
  const std::vector<std::string> patterns = allowed_functions();
  for (const std::string name : {"sin", "sinf", "cos", "sincos", "tan", "atan2", "acos", "exp", "expm1", "log", "pow",
                                 "powf", "cbrt", "hypot", "hypotf", "tgamma", "__muldc3", "__powidf2"})
    for (const std::string& pattern : patterns) EXPECT_NE(fnmatch(pattern.c_str(), name.c_str(), 0), 0) << name;
}

}  // namespace
}  // namespace morphcl::architecture
