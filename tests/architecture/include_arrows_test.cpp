#include "tests/architecture/include_arrows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace morphcl::architecture {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path source_root = MORPHCL_SOURCE_DIR;
const std::set<std::string> made_by_the_build = {"host/version.hpp"};

// A source tree of its own, removed at the end.
class PlantedTree : public testing::Test {
 protected:
  PlantedTree() {
    std::string name = (fs::temp_directory_path() / "morphcl-arrows-XXXXXX").string();
    root_ = mkdtemp(name.data());
  }
  ~PlantedTree() override { fs::remove_all(root_); }

  void plant(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  fs::path root_;
};

TEST(Architecture, EveryIncludeFollowsAnArrowOfTheLayout) {
  EXPECT_THAT(forbidden_includes(source_root, allowed_arrows(), made_by_the_build), IsEmpty());
}

TEST(Architecture, NoFilesIncludeEachOtherInACircle) { EXPECT_THAT(include_circles(source_root), IsEmpty()); }

TEST(Architecture, HeavyPackagesStayInTheirFolders) {
  EXPECT_THAT(forbidden_packages(source_root, {{"CLI/", {"cli", "demos", "bench"}},
                                               {"CL/", {"host/device"}},
                                               {"OpenEXR/", {"host/image", "tests", "bench"}},
                                               {"Imf", {"host/image", "tests", "bench"}},
                                               {"png.h", {"host/image", "tests"}},
                                               {"toml++/", {"host/scene"}},
                                               {"tiny_gltf.h", {"tests/scene"}},
                                               {"GLFW/", {"demos"}},
                                               {"gtest/", {"tests"}},
                                               {"boost/", {"host/accuracy", "tests", "bench"}}}),
              IsEmpty());
}

TEST(Architecture, TheArrowsThemselvesHaveNoCircle) {
  // Folders are removed once everything they point at is gone; a circle would never be removed.
  Arrows left = allowed_arrows();
  for (bool removed = true; removed;) {
    removed = false;
    for (auto folder = left.begin(); folder != left.end();) {
      const auto present = [&](const std::string& to) { return left.count(to) != 0; };
      const bool leaf = std::none_of(folder->second.begin(), folder->second.end(), present);
      folder = leaf ? left.erase(folder) : std::next(folder);
      removed = removed || leaf;
    }
  }
  EXPECT_THAT(left, IsEmpty());
}

TEST_F(PlantedTree, AForbiddenArrowIsNamedWithItsLine) {
  plant("host/render/plan.hpp", "");
  plant("host/math/angle.hpp", "#pragma once\n#include \"host/render/plan.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, allowed_arrows(), {}),
              ElementsAre("host/math/angle.hpp:2 includes host/render/plan.hpp; host/math may include: nothing"));
}

TEST_F(PlantedTree, OnlyItsOwnTestsIncludeTheTool) {
  plant("cli/console.hpp", "");
  plant("tests/cli/a.cpp", "#include \"cli/console.hpp\"\n");
  plant("tests/job/c.cpp", "#include \"cli/console.hpp\"\n");
  plant("host/job/b.cpp", "#  include \"cli/console.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, allowed_arrows(), {}),
              ElementsAre(HasSubstr("host/job/b.cpp:1"), HasSubstr("tests/job/c.cpp:1")));
}

TEST_F(PlantedTree, TheUmbrellaHeaderIsForUsersOnly) {
  plant("anim/track.hpp", "");
  plant("host/morphcl.hpp", "#include \"anim/track.hpp\"\n");
  plant("host/job/a.cpp", "#include \"host/morphcl.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, allowed_arrows(), {}), ElementsAre(HasSubstr("host/job/a.cpp:1")));
}

TEST_F(PlantedTree, AFileThatDoesNotExistFromTheRootIsNamed) {
  plant("anim/track.cpp", "#include \"track.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, allowed_arrows(), {}), ElementsAre(HasSubstr("no such file")));
  EXPECT_THAT(forbidden_includes(root_, allowed_arrows(), {"track.hpp"}), ElementsAre(HasSubstr("anim may include")));
}

TEST_F(PlantedTree, ACircleOfThreeIsPrintedOnce) {
  plant("anim/a.hpp", "#include \"anim/b.hpp\"\n");
  plant("anim/b.hpp", "#include \"anim/c.hpp\"\n");
  plant("anim/c.hpp", "#include \"anim/a.hpp\"\n");
  EXPECT_THAT(include_circles(root_), ElementsAre("anim/a.hpp -> anim/b.hpp -> anim/c.hpp -> anim/a.hpp"));
}

TEST_F(PlantedTree, APackageOutsideItsFolderIsNamed) {
  plant("host/math/angle.cpp", "#include <CL/opencl.hpp>\n");
  EXPECT_THAT(forbidden_packages(root_, {{"CL/", {"host/device"}}}),
              ElementsAre("host/math/angle.cpp:1 includes <CL/opencl.hpp>"));
}

}  // namespace
}  // namespace morphcl::architecture
