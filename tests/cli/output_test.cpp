// Places that cannot take the output.
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using testing::HasSubstr;

constexpr int cannot_create = 73, write_failed = 74;

class Output : public ToolTest {
 protected:
  std::vector<std::string> render(std::vector<std::string> options) {
    std::vector<std::string> arguments = {"render", plant("shot.toml", cube_shot()), "--device", "reference"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }
};

// A file system of 256 KiB, mounted for one test; only root may. `mounted` is false for everybody else.
class SmallDisk {
 public:
  explicit SmallDisk(const std::filesystem::path& folder) : folder_(folder) {
    std::filesystem::create_directory(folder);
    mounted = mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=256k") == 0;
  }
  ~SmallDisk() {
    if (mounted) umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool mounted;

 private:
  std::filesystem::path folder_;
};

// No process started meanwhile can write a longer file, as under `ulimit -f`.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_ = {};
};

TEST_F(Output, BelowAFile) {
  plant("taken", "not a folder");
  expect_one_line_error(run_tool(render({"-o", path("taken/f.####.exr")})), cannot_create, "taken");
  EXPECT_EQ(files(), (std::set<std::string>{"shot.toml", "taken"}));
}

TEST_F(Output, WhereNobodyMayWrite) {
  expect_one_line_error(run_tool(render({"-o", "/proc/morphcl/f.####.exr"})), cannot_create, "/proc/morphcl");
}

TEST_F(Output, ContactSheetBelowAFile) {
  plant("taken", "not a folder");
  const ToolResult result = run_tool(render({"--contact-sheet", path("taken/sheet.png")}), {.folder = folder_});
  EXPECT_EQ(result.code, cannot_create) << result.err;
  EXPECT_THAT(result.err, HasSubstr("sheet.png"));
}

TEST_F(Output, NewFoldersAreMade) {
  EXPECT_EQ(run_tool(render({"--frames", "3", "-o", path("new/deep/f.##.exr")})).code, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"new/deep/f.03.exr", "shot.toml"}));
}

// 512x512 uncompressed RGBA and Z are 3 MiB, more than the disk or the limit has room for.
TEST_F(Output, NoRoomLeft) {
  const SmallDisk disk(folder_ / "disk");
  ToolResult result;
  {
    const FileSizeLimit limit(disk.mounted ? RLIM_INFINITY : 256 << 10);
    result = run_tool(render({"--size", "512x512", "--compression", "none", "-o", path("disk/f.####.exr"), "--quiet"}));
  }
  EXPECT_EQ(result.code, write_failed) << result.err;
  EXPECT_THAT(result.err, HasSubstr("disk/f.0000.exr"));
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
}

TEST_F(Output, FileSizeLimitOfTheShell) {
  ToolResult result;
  {
    const FileSizeLimit limit(256 << 10);
    result =
        run_tool(render({"--size", "512x512", "--compression", "none", "-o", path("f.####.exr"), "--frames", "1"}));
  }
  expect_one_line_error(result, write_failed, "f.0001.exr");
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
}

// 5 frames fail for one reason: that is one line, and the closing line counts them.
TEST_F(Output, AFullDiskIsOneLine) {
  ToolResult result;
  {
    const FileSizeLimit limit(256 << 10);
    result =
        run_tool(render({"--size", "512x512", "--compression", "none", "-o", path("f.####.exr"), "--plan", "none"}));
  }
  expect_one_line_error(result, write_failed, "exr: File too large");
}

TEST_F(Output, FramesThatFailAreCountedInTheClosingLine) {
  std::filesystem::create_directories(folder_ / "f.0003.exr");
  std::filesystem::create_directories(folder_ / "f.0004.exr");
  const ToolResult result = run_tool(render({"-o", path("f.####.exr"), "--plan", "none"}));
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.err_lines().size(), 1u) << result.err;
  EXPECT_THAT(result.out, HasSubstr("3 frames rendered, 2 failed (3-4)"));
}

TEST_F(Output, AnInputIsNotOverwritten) {
  const std::string shot = plant("shot.toml", cube_shot());
  for (const std::string& sheet : {shot, path("shot.0003.exr")})
    expect_one_line_error(run_tool(render({"-o", path("shot.####.exr"), "--contact-sheet", sheet})), 2, "another name");
  expect_one_line_error(run_tool(render({"--frames", "0", "-o", shot})), 2, "ends in .toml");
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
  EXPECT_EQ(test_support::text_of(shot), cube_shot());
}

TEST_F(Output, ControlCharactersOfPathsAreNotPrinted) {
  const ToolResult result = run_tool(render({"--frames", "0", "-o", path("a\033[31m\xc2\x9b.exr")}));
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("a?[31m??.exr"));
  EXPECT_EQ((result.out + result.err).find_first_of("\033\x9b"), std::string::npos);
}

TEST_F(Output, HelpThatCannotBePrinted) {
  expect_one_line_error(run_tool({"--help"}, {.stdout_to = "/dev/full"}), write_failed, "stdout");
  expect_one_line_error(run_tool({"--version"}, {.stdout_to = "/dev/full"}), write_failed, "stdout");
}

TEST_F(Output, ResultsThatCannotBePrinted) {
  const ToolResult result = run_tool({"plan", plant("shot.toml", cube_shot())}, {.stdout_to = "/dev/full"});
  expect_one_line_error(result, write_failed, "stdout");
}

// By the shell, as only it starts a program with closed streams: "<&- 2>&-".
ToolResult run_with_closed_streams(const std::string& closed, const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {"sh", "-c", "exec \"$0\" \"$@\" " + closed};
  for (const std::string& word : tool_command(arguments)) command.push_back(word);
  return test_support::run_process(command);
}

// Files that are opened get the numbers of closed streams, and libraries print there.
TEST_F(Output, ClosedStreamsLeaveEveryFrameWhole) {
  const std::vector<std::string> job = render(
      {"--frames", "0-200", "--size", "64x36", "--threads", "4", "--plan", "none", "--json", "-o", path("f.####.exr")});
  const ToolResult result = run_with_closed_streams("<&- 2>&-", job);
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out_lines().size(), 202u);
  std::vector<std::string> again = job;
  again.push_back("--resume");
  EXPECT_THAT(run_tool(again).out, HasSubstr("\"kept\":201"));
}

TEST_F(Output, ResultsToAClosedStdoutAreLost) {
  const ToolResult result = run_with_closed_streams(">&-", {"plan", plant("shot.toml", cube_shot())});
  expect_one_line_error(result, write_failed, "stdout");
}

}  // namespace
}  // namespace morphcl::cli_test
