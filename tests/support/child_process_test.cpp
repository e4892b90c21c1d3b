// What the tests of programs lean on.
#include "tests/support/child_process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::test_support {
namespace {

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

TEST(ChildProcess, StreamsAreKeptApartOrTogether) {
  const std::string script = "echo a; echo b >&2; echo c; exit 3";
  const ProcessResult apart = run_process(shell(script));
  EXPECT_EQ(apart.code, 3);
  EXPECT_EQ(apart.out, "a\nc\n");
  EXPECT_EQ(apart.err, "b\n");
  EXPECT_FALSE(apart.timed_out);
  const ProcessResult together = run_process(shell(script), {.standard_error = StandardError::with_stdout});
  EXPECT_EQ(together.out, "a\nb\nc\n");
  EXPECT_EQ(together.err, "");
}

TEST(ChildProcess, ATerminalTakesMoreThanItHolds) {
  const ProcessResult result =
      run_process(shell("seq 1 20000 >&2; test -t 2 && echo terminal"), {.standard_error = StandardError::terminal});
  EXPECT_EQ(result.out, "terminal\n");
  EXPECT_EQ(result.err_lines().size(), 20000u);
}

TEST(ChildProcess, EnvironmentIsChangedOrClean) {
  setenv("MORPHCL_TEST_VARIABLE", "1", 1);
  const std::vector<std::string> print = shell("echo ${MORPHCL_TEST_VARIABLE-none} $OTHER ${PATH:+path}");
  EXPECT_EQ(run_process(print).out, "1 path\n");
  EXPECT_EQ(run_process(print, {.environment = {{"MORPHCL_TEST_VARIABLE", std::nullopt}}}).out, "none path\n");
  EXPECT_EQ(run_process(print, {.environment = {{"OTHER", "2"}}, .inherits_environment = false}).out, "none 2 path\n");
  const std::vector<std::string> is_set = shell("echo ${MORPHCL_TEST_VARIABLE+set}");
  EXPECT_EQ(run_process(is_set, {.environment = {{"MORPHCL_TEST_VARIABLE", ""}}}).out, "set\n");
  unsetenv("MORPHCL_TEST_VARIABLE");
}

TEST(ChildProcess, RunsInItsFolderAndLeavesNothingThere) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_process({"pwd"}, {.folder = folder.path()}).out, folder.path().string() + "\n");
  EXPECT_TRUE(folder.names().empty());
}

TEST(ChildProcess, IsKilledAfterTheLimit) {
  const ProcessResult result = run_process({"sleep", "60"}, {.limit = std::chrono::seconds(0)});
  EXPECT_TRUE(result.timed_out);
  EXPECT_EQ(result.code, 128 + SIGKILL);
}

TEST(ChildProcess, ASignalIsSentOnceItIsHandled) {
  ChildProcess process(shell("trap 'exit 7' USR1; while :; do sleep 0.01; done"));
  ASSERT_TRUE(process.wait_until_it_handles(SIGUSR1));
  EXPECT_TRUE(process.runs());
  process.signal(SIGUSR1);
  EXPECT_EQ(process.finish().code, 7);
  EXPECT_FALSE(process.runs());
  EXPECT_FALSE(process.wait_until_it_handles(SIGUSR1));
}

TEST(ChildProcess, EndsWithTheTest) {
  pid_t pid = 0;
  {
    const ChildProcess process({"sleep", "60"});
    pid = process.pid();
    EXPECT_EQ(kill(pid, 0), 0);
  }
  EXPECT_EQ(kill(pid, 0), -1);
}

TEST(ChildProcess, AProgramThatIsMissingIsAnError) {
  EXPECT_THROW(run_process({"/no/such/program"}), std::runtime_error);
}

TEST(TemporaryFolder, HasItsFilesAndGoesWithThem) {
  std::filesystem::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    EXPECT_EQ(text_of(folder.write("a/b", "xyz")), "xyz");
    write_bytes(folder / ".c", {'x'});
    EXPECT_EQ(bytes_of(folder / ".c"), std::vector<char>{'x'});
    EXPECT_EQ(folder.names(), (std::set<std::string>{".c", "a"}));
    EXPECT_EQ(folder.files(), (std::set<std::string>{".c", "a/b"}));
    EXPECT_THROW(bytes_of(folder / "none"), std::runtime_error);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace morphcl::test_support
