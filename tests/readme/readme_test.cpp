// What the README and the first shot show is what the repository holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

namespace fs = std::filesystem;
using test_support::text_of;

const fs::path root = MORPHCL_SOURCE_DIR;

std::ptrdiff_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(Readme, ItsProgramIsTheOneThatIsBuiltAndRun) {
  const std::string readme = text_of(root / "README.md");
  const std::string opening = "```cpp\n";
  const std::size_t begin = readme.find(opening) + opening.size(), end = readme.find("```", begin);
  ASSERT_LT(begin, end);
  EXPECT_EQ(readme.substr(begin, end - begin), text_of(root / "demos/first_program.cpp"));
}

TEST(Geometry, ItsProgramIsTheOneThatIsBuiltAndRun) {
  const std::string page = text_of(root / "docs/geometry.md");
  EXPECT_NE(page.find("```cpp\n" + text_of(root / "demos/geometry_program.cpp") + "```"), std::string::npos);
}

TEST(Readme, IsShortAndSoIsItsProgram) {
  EXPECT_LT(lines(text_of(root / "README.md")), 150);
  EXPECT_LT(lines(text_of(root / "demos/first_program.cpp")), 40);
}

TEST(Readme, EveryFileAndFolderThatItLinksToExists) {
  const std::string readme = text_of(root / "README.md");
  const std::regex link(R"(\]\(([^)#:]+)\))");
  const std::sregex_iterator first(readme.begin(), readme.end(), link), last;
  EXPECT_GT(std::distance(first, last), 5);
  for (auto match = first; match != last; ++match) EXPECT_TRUE(fs::exists(root / (*match)[1].str())) << (*match)[1];
}

TEST(Readme, ThePictureIsSmall) { EXPECT_LT(fs::file_size(root / "docs/overview.png"), 300'000u); }

TEST(Readme, EveryShotThatItNamesExists) {
  const std::string readme = text_of(root / "README.md");
  const std::regex shot(R"(demos/[a-z_]+\.toml)");
  for (std::sregex_iterator match(readme.begin(), readme.end(), shot), last; match != last; ++match)
    EXPECT_TRUE(fs::exists(root / match->str())) << match->str();
}

// docs/first-shot.md: what a step shows of its file is in it, and what the page links to is there.
TEST(FirstShot, ShowsWhatItsFilesHold) {
  const std::string page = text_of(root / "docs/first-shot.md");
  const std::regex part(R"(\n## ([1-5])\. |```toml\n([^`]+)```|\]\(([^)#:]+)\))");
  std::string file;
  int steps = 0, blocks = 0, links = 0;
  for (std::sregex_iterator match(page.begin(), page.end(), part), last; match != last; ++match) {
    if ((*match)[1].matched) {
      file = text_of(root / "docs/first-shot" / ((*match)[1].str() + ".toml"));
      ++steps;
    } else if ((*match)[2].matched) {
      EXPECT_NE(file.find((*match)[2].str()), std::string::npos) << "not in its file:\n" << (*match)[2];
      ++blocks;
    } else {
      EXPECT_TRUE(fs::exists(root / "docs" / (*match)[3].str())) << (*match)[3];
      ++links;
    }
  }
  EXPECT_EQ(steps, 5);
  EXPECT_GE(blocks, 5);
  EXPECT_GE(links, 5);
}

}  // namespace
}  // namespace morphcl
