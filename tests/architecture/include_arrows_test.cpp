#include "tests/architecture/include_arrows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::architecture {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path source_root = MORPHCL_SOURCE_DIR;
const Rooms rooms = read_rooms(source_root);
const std::set<std::string> made_by_the_build = {};

// A source tree of its own, removed at the end.
class PlantedTree : public testing::Test {
 protected:
  void plant(const std::string& path, const std::string& text) { folder_.write(path, text); }

 private:
  const test_support::TemporaryFolder folder_;

 protected:
  const fs::path& root_ = folder_.path();
};

TEST(Architecture, EveryIncludeFollowsAnArrowOfTheLayout) {
  EXPECT_THAT(forbidden_includes(source_root, rooms, made_by_the_build), IsEmpty());
}

TEST(Architecture, NoFilesIncludeEachOtherInACircle) { EXPECT_THAT(include_circles(source_root), IsEmpty()); }

TEST(Architecture, HeavyPackagesStayInTheirFolders) {
  EXPECT_THAT(forbidden_packages(source_root, {{"CLI/", {"cli", "demos", "bench"}},
                                               {"CL/", {"include/morphcl/opencl_interop.hpp"}},
                                               {"OpenEXR/", {"host/image", "tests", "bench"}},
                                               {"Imf", {"host/image", "tests", "bench"}},
                                               {"png.h", {"host/image", "tests"}},
                                               {"toml++/", {"host/scene/shot"}},
                                               {"tiny_gltf.h", {"tests/scene"}},
                                               {"GLFW/", {"demos"}},
                                               {"gtest/", {"tests"}},
                                               {"boost/", {"lab/accuracy", "tests", "bench"}}}),
              IsEmpty());
}

TEST(Architecture, TheArrowsThemselvesHaveNoCircle) {
  EXPECT_THAT(rooms_in_circles(rooms), IsEmpty());
  EXPECT_THAT(rooms_in_circles({{"a", {{"b"}, {}}}, {"b", {{"a"}, {}}}, {"c", {{}, {}}}}), ElementsAre("a", "b"));
}

TEST(Architecture, EveryRoomIsAFolder) {
  for (const auto& entry : rooms) EXPECT_TRUE(fs::is_directory(source_root / entry.first)) << entry.first;
}

TEST_F(PlantedTree, AForbiddenArrowIsNamedWithItsLine) {
  plant("host/render/plan/planner.hpp", "");
  plant("host/math/angle.hpp", "#pragma once\n#include \"host/render/plan/planner.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, rooms, {}),
              ElementsAre("host/math/angle.hpp:2 includes host/render/plan/planner.hpp; host/math may include: host"));
}

TEST_F(PlantedTree, RoomsInsideARoomAreKeptApart) {
  plant("host/render/reference/shade.hpp", "");
  plant("host/render/plan/planner.cpp", "#include \"host/render/reference/shade.hpp\"\n");
  plant("host/render/reference/visibility.cpp", "#include \"host/render/plan/view.hpp\"\n");
  plant("host/render/plan/view.hpp", "");
  plant("host/scene/obj/obj_file.hpp", "");
  plant("host/scene/gltf/gltf_mesh.cpp", "#include \"host/scene/obj/obj_file.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, rooms, {}), ElementsAre(HasSubstr("host/render/plan/planner.cpp:1"),
                                                                HasSubstr("host/render/reference/visibility.cpp:1"),
                                                                HasSubstr("host/scene/gltf/gltf_mesh.cpp:1")));
}

TEST_F(PlantedTree, TheLibraryDoesNotKnowTheLab) {
  plant("lab/accuracy/report.hpp", "");
  plant("host/job/a.cpp", "#include \"lab/accuracy/report.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, rooms, {}), ElementsAre(HasSubstr("host/job/a.cpp:1")));
}

TEST_F(PlantedTree, APublicHeaderIncludesPublicHeadersOnly) {
  const Rooms planted = {{"host/math", {{}, {"angle"}}}, {"host/job", {{"host/math"}, {"job"}}}};
  plant("host/math/sine.hpp", "");
  plant("include/morphcl/angle.hpp", "#include \"host/math/sine.hpp\"\n#include <morphcl/job.hpp>\n");
  plant("include/morphcl/job.hpp", "#include <morphcl/angle.hpp>\n");
  plant("include/morphcl/stray.hpp", "#include <morphcl/angle.hpp>\n");
  plant("include/morphcl/morphcl.hpp", "#include <morphcl/job.hpp>\n");
  plant("host/job/a.cpp", "#include \"morphcl/morphcl.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, planted, {}),
              ElementsAre(HasSubstr("host/job/a.cpp:1"), HasSubstr("include/morphcl/angle.hpp:1"),
                          HasSubstr("include/morphcl/angle.hpp:2"), HasSubstr("include/morphcl/stray.hpp:1")));
}

TEST_F(PlantedTree, AListThatNamesARoomTwiceOrNoneIsRefused) {
  plant("cmake/rooms.txt", "a:\na:\n");
  EXPECT_THROW(read_rooms(root_), std::runtime_error);
  plant("cmake/rooms.txt", "a: b\n");
  EXPECT_THROW(read_rooms(root_), std::runtime_error);
}

TEST_F(PlantedTree, OnlyItsOwnTestsIncludeTheTool) {
  plant("cli/console.hpp", "");
  plant("tests/cli/a.cpp", "#include \"cli/console.hpp\"\n");
  plant("tests/job/c.cpp", "#include \"cli/console.hpp\"\n");
  plant("host/job/b.cpp", "#  include \"cli/console.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, rooms, {}),
              ElementsAre(HasSubstr("host/job/b.cpp:1"), HasSubstr("tests/job/c.cpp:1")));
}

TEST_F(PlantedTree, AFileThatDoesNotExistFromTheRootIsNamed) {
  plant("anim/track.cpp", "#include \"track.hpp\"\n");
  EXPECT_THAT(forbidden_includes(root_, rooms, {}), ElementsAre(HasSubstr("no such file")));
  EXPECT_THAT(forbidden_includes(root_, rooms, {"track.hpp"}), ElementsAre(HasSubstr("anim may include")));
}

TEST_F(PlantedTree, ACircleOfThreeIsPrintedOnce) {
  plant("anim/a.hpp", "#include \"anim/b.hpp\"\n");
  plant("anim/b.hpp", "#include \"anim/c.hpp\"\n");
  plant("anim/c.hpp", "#include \"anim/a.hpp\"\n");
  EXPECT_THAT(include_circles(root_), ElementsAre("anim/a.hpp -> anim/b.hpp -> anim/c.hpp -> anim/a.hpp"));
}

TEST_F(PlantedTree, APackageOutsideItsFolderIsNamed) {
  plant("host/math/angle.cpp", "#include <CL/opencl.hpp>\n");
  EXPECT_THAT(forbidden_packages(root_, {{"CL/", {"include/morphcl/opencl_interop.hpp"}}}),
              ElementsAre("host/math/angle.cpp:1 includes <CL/opencl.hpp>"));
}

}  // namespace
}  // namespace morphcl::architecture
