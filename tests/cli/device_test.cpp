// OpenCL devices: none, unknown ones, the list, and the cache of compiled kernels.
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr int no_device = 69;

class Device : public ToolTest {
 protected:
  Device() {
    plant("shot.toml", cube_shot());
    std::filesystem::create_directory(folder_ / "no_drivers");
  }

  ToolOptions without_drivers() const {
    return {.environment = {{"OCL_ICD_VENDORS", path("no_drivers")}}, .folder = folder_};
  }
  ToolOptions with_cache() const { return {.environment = {{"MORPHCL_CACHE_DIR", path("cache")}}, .folder = folder_}; }

  // The pixel hash of frame 2, which the device that is named has to draw.
  std::string hash(const std::string& device) const {
    const ToolResult result =
        run_tool({"render", path("shot.toml"), "--frames", "2", "--json", "--device", device}, with_cache());
    EXPECT_EQ(result.code, 0) << result.err;
    if (result.out.empty()) return "";
    const json frame = json::parse(result.out_lines().front());
    EXPECT_EQ(frame.at("drawn_by") == "reference", device == "reference") << frame;
    return frame.value("hash", "");
  }
};

TEST_F(Device, NoneIsOneLineThatNamesThePackage) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"render", path("shot.toml"), "--device", "0"}, {"devices"}, {"warm"}})
    expect_one_line_error(run_tool(arguments, without_drivers()), no_device, "pocl-opencl-icd");
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
}

TEST_F(Device, TheReferenceRendererNeedsNone) {
  const ToolResult result = run_tool({"render", path("shot.toml"), "--device", "reference"}, without_drivers());
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(run_tool({"plan", path("shot.toml")}, without_drivers()).code, 0);
}

TEST_F(Device, AnUnknownNameListsThoseThereAre) {
  expect_one_line_error(run_tool({"render", path("shot.toml"), "--device", "voodoo2"}, with_cache()), no_device,
                        "voodoo2");
  expect_one_line_error(run_tool({"render", path("shot.toml"), "--device", "99"}, with_cache()), no_device, "99");
  EXPECT_EQ(files_ending_in(".exr"), 0u);
}

// PoCL calls itself a device of 1 GiB then, and allocates a quarter of it at once.
TEST_F(Device, MeshesOverItsLimitAreRefusedWithBothNumbersOnEveryFrame) {
  plant("huge.toml", "[image]\nsize = [64, 48]\n[[object]]\nmesh = \"sphere_to_cube\"\nsegments = [3032, 3032]\n");
  ToolOptions small_device = with_cache();
  small_device.environment.emplace("POCL_MEMORY_LIMIT", "1");
  const ToolResult result =
      run_tool({"render", path("huge.toml"), "--frames", "0-1", "--json", "--device", "0"}, small_device);
  EXPECT_EQ(result.code, 65) << result.err;
  ASSERT_EQ(result.out_lines().size(), 3u) << result.out;
  for (int frame = 0; frame < 2; ++frame)
    EXPECT_THAT(json::parse(result.out_lines()[frame]).value("error", ""),
                testing::AllOf(HasSubstr("take 2"), HasSubstr("256 MiB")));
  EXPECT_EQ(files_ending_in(".exr"), 0u);
}

#ifndef MORPHCL_SANITIZED  // AddressSanitizer makes frames larger
// Threads keep the samples of a tile on their stacks.
TEST_F(Device, AStackTooSmallForTheSamplesIsOneLine) {
  const std::string tool = MORPHCL_TOOL;
  const auto with_stack = [&](const char* kilobytes, const char* samples) {
    return test_support::run_process(
        {"sh", "-c", "ulimit -s " + std::string(kilobytes) + "; exec \"$0\" \"$@\"", tool, "render", path("shot.toml"),
         "--frames", "0", "--device", "0", "--samples", samples},
        with_cache());
  };
  expect_one_line_error(with_stack("320", "16"), no_device, "ulimit -s");
  EXPECT_EQ(with_stack("320", "4").code, 0);
  EXPECT_EQ(with_stack("640", "16").code, 0);
}
#endif

TEST_F(Device, TheListHasAVerdictForEach) {
  const ToolResult result = run_tool({"devices", "--json"}, with_cache());
  EXPECT_EQ(result.code, 0) << result.err;
  ASSERT_FALSE(result.out_lines().empty());
  for (const std::string& line : result.out_lines()) {
    const json device = json::parse(line);
    EXPECT_NE(device.at("verdict"), "");
    EXPECT_GT(device.at("global_memory_bytes"), 0);
  }
  EXPECT_THAT(run_tool({"devices"}, with_cache()).out, HasSubstr("SELF-TEST"));
}

TEST_F(Device, GivesTheBitsOfTheReferenceWithColdWarmAndDamagedCache) {
  const std::string expected = hash("reference");
  EXPECT_EQ(hash("0"), expected) << "cold";
  EXPECT_EQ(run_tool({"warm"}, with_cache()).code, 0);
  EXPECT_EQ(hash("0"), expected) << "warm";
  std::size_t damaged = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "cache")) {
    if (!entry.is_regular_file()) continue;
    const auto half = entry.file_size() / 2;
    if (++damaged % 2 == 0)
      std::filesystem::resize_file(entry.path(), half);
    else
      std::fstream(entry.path(), std::ios::binary | std::ios::in | std::ios::out).seekp(static_cast<long>(half))
          << "damage";
  }
  EXPECT_GT(damaged, 0u);
  EXPECT_EQ(hash("0"), expected) << "damaged";
}

// Nothing is compiled, and so nothing stored, by what is rendered afterwards: small or in many parts, lit by face or by
// vertex, clipped or not.
TEST_F(Device, WarmCompilesEveryKernel) {
  const std::string sphere = "[image]\nsize = [64, 48]\n[[object]]\nmesh = \"sphere_to_cube\"\nsegments = [128, 64]\n";
  const std::string close = "[camera]\neye = [0, 0, 1.5]\nnear = 1.0\n";
  plant("smooth.toml", sphere);
  plant("flat.toml", sphere + "shading = \"flat\"\n");
  plant("smooth_clipped.toml", close + sphere);
  plant("flat_clipped.toml", close + sphere + "shading = \"flat\"\n");
  ASSERT_EQ(run_tool({"warm"}, with_cache()).code, 0);
  const std::set<std::string> stored = files();
  for (const std::string shot : {"shot.toml", "smooth.toml", "flat.toml", "smooth_clipped.toml", "flat_clipped.toml"}) {
    const ToolResult result =
        run_tool({"render", path(shot), "--frames", "0", "-o", path("frame.exr"), "--device", "0"}, with_cache());
    EXPECT_EQ(result.code, 0) << result.err;
    std::set<std::string> now = files();
    now.erase("frame.exr");
    EXPECT_EQ(now, stored) << shot;
  }
}

// Of a shot it compiles what this one needs, and nothing else.
TEST_F(Device, WarmOfAShotCompilesItsKernels) {
  plant("glass.toml",
        "[image]\nsize = [64, 48]\nsamples = 2\n[[object]]\nmesh = \"cube\"\nshading = \"flat\"\n"
        "color = [1, 1, 1, 0.5]\n");
  EXPECT_EQ(run_tool({"warm", path("glass.toml")}, with_cache()).code, 0);
  const std::set<std::string> stored = files();
  const ToolResult result =
      run_tool({"render", path("glass.toml"), "--frames", "0", "-o", path("frame.exr"), "--device", "0"}, with_cache());
  EXPECT_EQ(result.code, 0) << result.err;
  std::set<std::string> now = files();
  now.erase("frame.exr");
  EXPECT_EQ(now, stored);
  expect_one_line_error(run_tool({"warm", path("missing.toml")}, with_cache()), 66, "missing.toml");
}

TEST_F(Device, WarmOfTheReferenceRendererIsAMistake) {
  expect_one_line_error(run_tool({"warm", "--device", "reference"}), 2, "compiles nothing");
}

}  // namespace
}  // namespace morphcl::cli_test
