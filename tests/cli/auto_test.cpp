// `--device auto`, the default: who draws which frame is said, and what compiles beside the frames is never waited for.
#include <signal.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class Auto : public ToolTest {
 protected:
  Auto() {
    plant("shot.toml", cube_shot());
    std::filesystem::create_directory(folder_ / "temporary");
    std::filesystem::create_directory(folder_ / "no_drivers");
  }

  ToolOptions empty_cache() const {
    return {.environment = {{"MORPHCL_CACHE_DIR", path("cache")}, {"TMPDIR", path("temporary")}}, .folder = folder_};
  }

  static std::vector<json> objects(const ToolResult& result, const std::string& type) {
    std::vector<json> found;
    for (const std::string& line : result.out_lines())
      if (const json object = json::parse(line); object.at("type") == type) found.push_back(object);
    return found;
  }

  // A cube that moves for `frames` frames: by the reference each takes some milliseconds.
  std::string moving_shot(int frames, const std::string& size = "[640, 360]") const {
    std::string shot = replaced(cube_shot(), "size = [32, 18]", "size = " + size);
    shot = replaced(shot, "range = \"0-4\"", "range = \"0-100000\"");
    return plant("moving.toml",
                 replaced(shot, "[4, [1.0, 0.0, 0.0]]", "[" + std::to_string(frames - 1) + ", [1.0, 0.0, 0.0]]"));
  }

  // Everything below the folder but finished frames and the shots.
  std::set<std::string> leftovers() const {
    std::set<std::string> left;
    for (const std::string& name : files())
      if (!name.ends_with(".exr") && !name.ends_with(".toml")) left.insert(name);
    return left;
  }

  static std::size_t temporary_files(const std::set<std::string>& names) {
    return static_cast<std::size_t>(std::count_if(names.begin(), names.end(), [](const std::string& name) {
      return name.find("morphcl-tmp") != std::string::npos || name.starts_with("temporary/");
    }));
  }

  // Until the driver has its folder: the device is being opened or kernels are compiled, for seconds.
  void wait_until_it_prepares(test_support::ChildProcess& process) const {
    while (std::filesystem::is_empty(folder_ / "temporary")) {
      ASSERT_TRUE(process.runs()) << process.err();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
};

TEST_F(Auto, AShortJobIsTheReferencesAndCompilesNothing) {
  const ToolResult result = run_tool({"render", path("shot.toml"), "--json", "--quiet"}, empty_cache());
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const std::vector<json> frames = objects(result, "frame");
  ASSERT_EQ(frames.size(), 5u);
  for (const json& frame : frames) EXPECT_EQ(frame.at("drawn_by"), "reference");
  const json summary = objects(result, "summary").at(0);
  EXPECT_EQ(summary.at("device"), "auto");
  EXPECT_EQ(summary.at("drawn_by"), (json{{"reference", 5}}));
  EXPECT_EQ(summary.at("note"), "");
  EXPECT_EQ(leftovers(), std::set<std::string>());
  EXPECT_THAT(run_tool({"render", path("shot.toml")}, empty_cache()).out,
              HasSubstr("5 frames rendered on reference in "));
}

TEST_F(Auto, IsTheDefaultAndHasAName) {
  for (const std::vector<std::string>& device : {std::vector<std::string>{}, {"--device", "auto"}}) {
    std::vector<std::string> arguments = {"render", path("shot.toml"), "--json"};
    arguments.insert(arguments.end(), device.begin(), device.end());
    EXPECT_EQ(objects(run_tool(arguments, empty_cache()), "summary").at(0).at("device"), "auto");
  }
  EXPECT_THAT(run_tool({"render", "--help"}).out, HasSubstr("auto (default)"));
}

TEST_F(Auto, ANamedDeviceDrawsEveryFrame) {
  const ToolResult result = run_tool({"render", path("shot.toml"), "--device", "0", "--json"}, {.folder = folder_});
  ASSERT_EQ(result.code, 0) << result.err;
  const json summary = objects(result, "summary").at(0);
  EXPECT_EQ(summary.at("drawn_by"), (json{{summary.at("device"), 5}}));
  for (const json& frame : objects(result, "frame")) EXPECT_EQ(frame.at("drawn_by"), summary.at("device"));
}

// What is kept, copied or failed was drawn by nobody.
TEST_F(Auto, OnlyRenderedFramesAreDrawnBySomebody) {
  ASSERT_EQ(run_tool({"render", path("shot.toml"), "--frames", "0-1"}, empty_cache()).code, 0);
  const ToolResult result =
      run_tool({"render", path("shot.toml"), "--frames", "0-6", "--resume", "--json"}, empty_cache());
  for (const json& frame : objects(result, "frame"))
    EXPECT_EQ(frame.contains("drawn_by"), frame.at("status") == "rendered") << frame;
  EXPECT_EQ(objects(result, "summary").at(0).at("drawn_by"), (json{{"reference", 3}}));
}

TEST_F(Auto, FilesDoNotKnowWhoDrewThem) {
  const auto bytes = [this](const std::string& device) {
    const std::string file = device + ".exr";
    EXPECT_EQ(run_tool({"render", path("shot.toml"), "--frames", "3", "-o", path(file), "--device", device}).code, 0);
    return test_support::text_of(path(file));
  };
  const std::string by_reference = bytes("reference");
  EXPECT_FALSE(by_reference.empty());
  EXPECT_EQ(bytes("auto"), by_reference);
  EXPECT_EQ(bytes("0"), by_reference);
}

// Two frames move, the others are copies of the last one: the job ends long before the compiler.
TEST_F(Auto, AJobThatEndsWhileKernelsCompileLeavesNothingBehind) {
  const ToolResult result = run_tool({"render", moving_shot(3, "[1920, 1080]"), "--frames", "0-300", "-o",
                                      path("out/f.####.exr"), "--json", "--quiet"},
                                     empty_cache());
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(files_ending_in(".exr"), 301u);
  EXPECT_EQ(temporary_files(files()), 0u);
}

TEST_F(Auto, AStopWhileKernelsCompileIsHeard) {
  for (int number : {SIGTERM, SIGINT, SIGUSR1, SIGHUP}) {
    test_support::ChildProcess process(tool_command({"render", moving_shot(100'000), "-o", path("out/f.######.exr")}),
                                       empty_cache());
    wait_until_it_prepares(process);
    process.signal(number);
    const ToolResult result = process.finish();
    EXPECT_EQ(result.code, 75) << result.err;
    ASSERT_EQ(result.err_lines().size(), 1u) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--resume"));
    EXPECT_EQ(temporary_files(files()), 0u);
    std::filesystem::remove_all(folder_ / "out");
    std::filesystem::remove_all(folder_ / "cache");
  }
}

// On one thread nothing is drawn while kernels compile.
TEST_F(Auto, AStopWhileTheOnlyThreadCompilesIsHeard) {
  test_support::ChildProcess process(
      tool_command({"render", moving_shot(100'000), "-o", path("out/f.######.exr"), "--threads", "1"}), empty_cache());
  wait_until_it_prepares(process);
  process.signal(SIGTERM);
  const ToolResult result = process.finish();
  EXPECT_EQ(result.code, 75) << result.err;
  EXPECT_EQ(result.err_lines().size(), 1u) << result.err;
  EXPECT_EQ(temporary_files(files()), 0u);
}

TEST_F(Auto, WithoutADeviceTheReferenceDrawsAllAndANoteSaysWhyOnce) {
  ASSERT_EQ(run_tool({"warm"}).code, 0);  // the cache that other tests use: a hint that the device is worth asking for
  ToolOptions without = {.environment = {{"OCL_ICD_VENDORS", path("no_drivers")}}, .folder = folder_};
  const std::vector<std::string> job = {"render", moving_shot(400), "--frames", "0-399", "-o", path("out/f.####.exr")};
  const ToolResult result = run_tool(job, without);
  EXPECT_EQ(result.code, 0) << result.err;
  ASSERT_EQ(result.err_lines().size(), 1u) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: "));
  EXPECT_THAT(result.err, HasSubstr("pocl-opencl-icd"));
  EXPECT_THAT(result.out, HasSubstr("400 frames rendered on reference in "));
}

// Where neither can draw: here the frame's own memory is more than there may be.
#ifndef MORPHCL_SANITIZED  // AddressSanitizer maps terabytes
TEST_F(Auto, WhatNoRendererHasRoomForIsOneLine) {
  const std::string tool = MORPHCL_TOOL;
  const ToolResult result = test_support::run_process(
      {"sh", "-c", "ulimit -v 700000; exec \"$0\" \"$@\"", tool, "render", path("shot.toml"), "--size", "16384x16384"},
      empty_cache());
  expect_one_line_error(result, 69, "takes");
}
#endif

TEST_F(Auto, PlanSaysWhoWillDraw) {
  const auto total = [](const ToolResult& result) { return objects(result, "plan_total").at(0); };
  const json few = total(run_tool({"plan", path("shot.toml"), "--json"}, empty_cache()));
  EXPECT_EQ(few.at("drawn_by"), "reference");
  EXPECT_EQ(few.at("first_drawn_by"), "reference");
  EXPECT_TRUE(few.at("compiles"));
  EXPECT_GT(few.at("preparing_seconds"), 1);
  EXPECT_GT(few.at("reference_ms"), 0);
  EXPECT_GT(few.at("device_ms"), 0);
  const json many = total(run_tool({"plan", moving_shot(100'000), "--json"}, empty_cache()));
  EXPECT_THAT(many.at("drawn_by"), AnyOf("by_turns", "device"));
  EXPECT_THAT(run_tool({"plan", path("shot.toml")}, empty_cache()).out,
              HasSubstr("with --device auto 5 frames are drawn by the reference"));
  ASSERT_EQ(run_tool({"warm"}).code, 0);
  EXPECT_FALSE(total(run_tool({"plan", path("shot.toml"), "--json"})).at("compiles"))
      << "the cache is known to be warm";
}

TEST_F(Auto, CompareSaysWhoDrew) {
  const ToolResult result = run_tool({"compare", path("shot.toml"), "--json"}, empty_cache());
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(objects(result, "frame_error").at(0).at("drawn_by"), "reference");
  EXPECT_THAT(run_tool({"compare", path("shot.toml"), "--device", "0"}).out, Not(HasSubstr("drawn by reference")));
  EXPECT_THAT(run_tool({"compare", path("shot.toml")}, empty_cache()).out, HasSubstr("drawn by reference"));
}

}  // namespace
}  // namespace morphcl::cli_test
