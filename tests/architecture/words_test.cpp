// The words of tests/architecture/words.txt stand in no name of the library.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::architecture {
namespace {

namespace fs = std::filesystem;
using test_support::text_of;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

const fs::path repository = MORPHCL_SOURCE_DIR;

std::vector<std::string> listed_words() {
  std::vector<std::string> words;
  std::istringstream lines(text_of(repository / "tests/architecture/words.txt"));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '#') words.push_back(line.substr(0, line.find(' ')));
  return words;
}

// "mostWanted_thing" as "_most_wanted_thing_", so that a word is found in it by its parts.
std::string in_parts(const std::string& name) {
  std::string parts = "_";
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto is = [&name](int (*kind)(int), std::size_t at) {
      return kind(static_cast<unsigned char>(name[at])) != 0;
    };
    if (i > 0 && is(std::isupper, i) && is(std::islower, i - 1)) parts += '_';
    parts += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return parts + "_";
}

// The identifiers of C++ or OpenCL C: what stands in comments and in texts is not one.
std::set<std::string> identifiers(const std::string& code) {
  std::set<std::string> found;
  const auto starts = [&code](std::size_t at, const char* what) {
    return code.compare(at, std::strlen(what), what) == 0;
  };
  const auto skip_past = [&code](std::size_t at, const std::string& end) {
    const std::size_t found_at = code.find(end, at);
    return found_at == std::string::npos ? code.size() : found_at + end.size();
  };
  for (std::size_t at = 0; at < code.size();) {
    const auto letter = [&code](std::size_t i) {
      return i < code.size() && (std::isalnum(static_cast<unsigned char>(code[i])) || code[i] == '_');
    };
    if (starts(at, "//")) {
      at = skip_past(at, "\n");
    } else if (starts(at, "/*")) {
      at = skip_past(at, "*/");
    } else if (starts(at, "R\"")) {
      const std::size_t open = code.find('(', at);
      at = skip_past(open, ")" + code.substr(at + 2, open - at - 2) + "\"");
    } else if (code[at] == '"') {
      for (++at; at < code.size() && code[at] != '"'; ++at)
        if (code[at] == '\\') ++at;
      ++at;
    } else if (code[at] == '\'' && (at == 0 || !letter(at - 1))) {  // a character, not a mark between digits
      at += code.compare(at, 2, "'\\") == 0 ? 3 : 2;
      at = skip_past(at, "'");
    } else if (letter(at)) {
      const std::size_t first = at;
      while (letter(at)) ++at;
      if (!std::isdigit(static_cast<unsigned char>(code[first]))) found.insert(code.substr(first, at - first));
    } else {
      ++at;
    }
  }
  return found;
}

std::vector<std::string> unwanted_names(const fs::path& path, const std::vector<std::string>& words) {
  std::set<std::string> names = identifiers(text_of(path));
  names.insert(path.stem().string());
  std::vector<std::string> unwanted;
  for (const std::string& name : names)
    for (const std::string& word : words)
      if (in_parts(name).find(in_parts(word)) != std::string::npos) unwanted.push_back(name);
  return unwanted;
}

TEST(Words, NoNameOfTheLibraryHasOneThatIsListed) {
  const std::vector<std::string> words = listed_words();
  ASSERT_THAT(words, Not(IsEmpty()));
  std::size_t files = 0;
  for (const char* folder : {"kernels", "host", "anim", "include"})
    for (const auto& entry : fs::recursive_directory_iterator(repository / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".h" && extension != ".cl") continue;
      ++files;
      EXPECT_THAT(unwanted_names(entry.path(), words), IsEmpty()) << entry.path();
    }
  EXPECT_GT(files, 300u);
}

TEST(Words, AreFoundInNamesAndNowhereElse) {
  EXPECT_THAT(identifiers("a == '\"' || b == '\\'' || c == 1'000 || d"), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(identifiers("int least_w = 3;  // least\nf(\"most\", R\"x(greatest)x\"); /* most */ #define MOST 1"),
              ElementsAre("MOST", "define", "f", "int", "least_w"));
  EXPECT_EQ(in_parts("mostWanted_thing"), "_most_wanted_thing_");
  EXPECT_EQ(in_parts("FETCH_AHEAD"), "_fetch_ahead_");
  const test_support::TemporaryFolder folder;
  const fs::path planted = folder.write("closeness.cpp", "float leastWeight, leftmost, most_;  // greatest\n");
  EXPECT_THAT(unwanted_names(planted, {"least", "most", "closeness"}),
              UnorderedElementsAre("leastWeight", "most_", planted.stem().string()));
}

}  // namespace
}  // namespace morphcl::architecture
