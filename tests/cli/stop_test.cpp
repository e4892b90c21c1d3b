// Jobs that are stopped: by a signal that asks, by two, and by one that does not ask.
#include <signal.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr int interrupted = 75;
constexpr std::size_t enough_files = 3;

class Stop : public ToolTest {
 protected:
  Stop() { plant("shot.toml", cube_shot()); }

  std::vector<std::string> job(const std::string& frames, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"render", path("shot.toml"), "--device", "reference", "--frames", frames};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }

  static std::string range_to(std::size_t last) { return std::string("0-").append(std::to_string(last)); }

  void wait_for_files() const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (files_ending_in(".exr") < enough_files && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_GE(files_ending_in(".exr"), enough_files);
  }

  // Every file under a final name decodes to the pixels it was written with.
  void expect_only_whole_frames() const {
    for (const std::string& name : files()) {
      if (name.rfind("shot.", 0) != 0 || name == "shot.toml") continue;
      EXPECT_EQ(run_tool({"info", path(name)}).code, 0) << name;
    }
  }

  std::map<int, std::string> hashes(const std::vector<std::string>& arguments) const {
    const ToolResult result = run_tool(arguments, {.folder = folder_});
    EXPECT_EQ(result.code, 0) << result.err;
    std::map<int, std::string> found;
    for (const std::string& line : result.out_lines())
      if (const json object = json::parse(line); object.at("type") == "frame")
        found[object.at("frame")] = object.at("hash");
    return found;
  }
};

TEST_F(Stop, EachSignalEndsTheJobAfterTheCurrentFramesAndResumeGoesOn) {
  for (int number : {SIGTERM, SIGINT, SIGUSR1}) {
    test_support::ChildProcess process(
        tool_command(job("0-20000", {"-o", path(std::to_string(number)) + "/shot.#####.exr"})), {});
    while (files_ending_in(".exr") == 0) ASSERT_TRUE(process.wait_until_it_handles(number));
    process.signal(number);
    const ToolResult result = process.finish();
    EXPECT_EQ(result.code, interrupted);
    ASSERT_EQ(result.err_lines().size(), 1u) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--resume"));
    EXPECT_EQ(files_ending_in(".exr") + 1, files().size()) << "something else was left behind";
    std::filesystem::remove_all(folder_ / std::to_string(number));
  }
}

// LLVM, which comes with a device, puts handlers of its own over those that it finds.
TEST_F(Stop, EachSignalIsHeardByAJobOnADevice) {
  for (int number : {SIGUSR1, SIGTERM, SIGINT, SIGHUP}) {
    const std::string folder = path(std::to_string(number));
    test_support::ChildProcess process(tool_command(
        {"render", path("shot.toml"), "--frames", "0-200000", "-o", folder + "/shot.######.exr", "--device", "0"}));
    while (files_ending_in(".exr") < enough_files) ASSERT_TRUE(process.runs()) << process.err();
    process.signal(number);
    const ToolResult result = process.finish();
    EXPECT_EQ(result.code, interrupted) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--resume"));
    EXPECT_EQ(files_ending_in(".exr") + 1, files().size()) << "something else was left behind";
    std::filesystem::remove_all(folder);
  }
}

TEST_F(Stop, WhatNohupHasIgnoredIsIgnored) {
  std::vector<std::string> command = {"sh", "-c", "trap '' HUP; exec \"$0\" \"$@\""};
  for (const std::string& word : tool_command(job("0-300", {"-o", path("f.####.exr")}))) command.push_back(word);
  test_support::ChildProcess process(command);
  ASSERT_TRUE(process.wait_until_it_handles(SIGTERM));
  process.signal(SIGHUP);
  EXPECT_EQ(process.finish().code, 0);
}

// One that does not look at the flag for long: compare draws, and looks at nothing meanwhile.
TEST_F(Stop, WhatTakesLongerIsEndedWithNothingLeftBehind) {
  test_support::ChildProcess process(tool_command(
      {"compare", path("shot.toml"), "--device", "reference", "--size", "8192x8192", "--out", path("out")}));
  ASSERT_TRUE(process.wait_until_it_handles(SIGTERM));
  process.signal(SIGTERM);
  const ToolResult result = process.finish();
  EXPECT_EQ(result.code, interrupted);
  EXPECT_EQ(result.err, "morphcl: interrupted\n");
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
}

TEST_F(Stop, AfterATermTheFinishedFramesAreWholeAndKept) {
  test_support::ChildProcess process(tool_command(job("0-20000")), {.folder = folder_});
  wait_for_files();
  process.signal(SIGTERM);
  EXPECT_EQ(process.finish().code, interrupted);
  const std::size_t finished = files_ending_in(".exr");
  expect_only_whole_frames();
  const ToolResult resumed = run_tool(job(range_to(finished), {"--resume"}), {.folder = folder_});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_THAT(resumed.out, HasSubstr(std::to_string(finished) + " kept"));
}

// The frame is large, so that the process is still busy with it when the second signal comes.
TEST_F(Stop, ASecondSignalEndsTheProcessAtOnce) {
  test_support::ChildProcess process(tool_command(job("0-100", {"--size", "4096x4096"})), {.folder = folder_});
  ASSERT_TRUE(process.wait_until_it_handles(SIGTERM));
  process.signal(SIGTERM);
  process.signal(SIGINT);
  EXPECT_THAT(process.finish().code, testing::AnyOf(128 + SIGTERM, 128 + SIGINT));
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"}) << "something was left behind";
}

// PoCL's folder, and what is on its way to the disk.
TEST_F(Stop, ASecondSignalLeavesNothingBehindInAJobOnADevice) {
  std::filesystem::create_directory(folder_ / "temporary");
  test_support::ChildProcess process(tool_command({"render", path("shot.toml"), "--frames", "0-200000", "-o",
                                                   path("out/f.######.exr"), "--device", "0"}),
                                     {.environment = {{"TMPDIR", path("temporary")}}});
  while (files_ending_in(".exr") < enough_files) ASSERT_TRUE(process.runs()) << process.err();
  EXPECT_FALSE(std::filesystem::is_empty(folder_ / "temporary"));
  process.signal(SIGTERM);
  process.signal(SIGUSR1);
  EXPECT_THAT(process.finish().code, testing::AnyOf(128 + SIGTERM, 128 + SIGUSR1));
  EXPECT_EQ(files_ending_in(".exr") + 1, files().size());
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "temporary"));
}

TEST_F(Stop, KilledInTheMiddleItLeavesWholeFramesAndResumeCompletesThem) {
  test_support::ChildProcess process(tool_command(job("0-20000")), {.folder = folder_});
  wait_for_files();
  process.signal(SIGKILL);
  EXPECT_EQ(process.finish().code, 128 + SIGKILL);
  expect_only_whole_frames();
  const std::string range = range_to(files_ending_in(".exr") + 4);
  const auto resumed = hashes(job(range, {"--resume", "--json"}));
  const auto fresh = hashes(job(range, {"-o", path("fresh") + "/f.#####.exr", "--json"}));
  EXPECT_EQ(resumed, fresh);
  for (const std::string& name : files()) EXPECT_THAT(name, testing::AnyOf(testing::EndsWith(".exr"), "shot.toml"));
}

}  // namespace
}  // namespace morphcl::cli_test
