// Processes that share a cache folder, damaged files in it, and folders that cannot be written.
#include "host/device/program_cache.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <fstream>
#include <map>
#include <set>

#include "tests/device/run_device_child.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

namespace fs = std::filesystem;
using test_support::ChildProcess;
using test_support::Environment;
using test_support::TemporaryFolder;
using testing::ChildResult;
using testing::device_child_command;
using testing::run_device_child;

const std::vector<std::string> transform = {"arrays", "100"};  // three kernels of one program

Environment with_cache(const fs::path& folder) { return {{"MORPHCL_CACHE_DIR", folder.string()}}; }

std::set<fs::path> files_with(const fs::path& folder, const std::string& extension) {
  std::set<fs::path> files;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder / "programs", missing))
    if (entry.path().extension() == extension) files.insert(entry.path());
  return files;
}

std::string expect_hash(const ChildResult& result) {
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NE(result.value("hash"), "") << result.output;
  return result.value("hash");
}

// The hash without any cache: what every other run must give.
const std::string& expected_hash() {
  static const std::string hash = expect_hash(run_device_child(transform, {{"MORPHCL_CACHE_DIR", "-"}}));
  return hash;
}

TEST(ProgramCacheFolder, HoldsProgramsAndVerdictAfterARun) {
  const TemporaryFolder cache;
  EXPECT_EQ(expect_hash(run_device_child(transform, with_cache(cache.path()))), expected_hash());
  EXPECT_EQ(files_with(cache.path(), ".clbin").size(), 5u);  // 3 batch transforms, 2 self-tests
  EXPECT_EQ(files_with(cache.path(), ".verdict").size(), 1u);
  EXPECT_EQ(files_with(cache.path(), ".tmp").size(), 0u);
  // A second run uses them as they are; PoCL's own cache went with the first.
  std::map<fs::path, fs::file_time_type> written;
  for (const auto& file : files_with(cache.path(), ".clbin")) written[file] = fs::last_write_time(file);
  EXPECT_FALSE(fs::exists(cache / "pocl"));
  EXPECT_EQ(expect_hash(run_device_child(transform, with_cache(cache.path()))), expected_hash());
  for (const auto& [file, time] : written) EXPECT_EQ(fs::last_write_time(file), time) << file;
}

TEST(ProgramCacheFolder, DamagedFilesAreIgnoredAndReplaced) {
  const TemporaryFolder cache;
  expect_hash(run_device_child(transform, with_cache(cache.path())));
  const auto damage = [&](const char* how, auto change) {
    for (const char* kind : {".clbin", ".verdict"})
      for (const auto& file : files_with(cache.path(), kind)) change(file);
    EXPECT_EQ(expect_hash(run_device_child(transform, with_cache(cache.path()))), expected_hash()) << how;
  };
  damage("cut", [](const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); });
  damage("emptied", [](const fs::path& file) { fs::resize_file(file, 0); });
  damage("overwritten in the middle", [](const fs::path& file) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(fs::file_size(file) / 2)).write("\xde\xad\xbe\xef", 4);
  });
  // Each was stored anew, so that one more run rewrites nothing.
  std::map<fs::path, fs::file_time_type> written;
  for (const auto& file : files_with(cache.path(), ".clbin")) written[file] = fs::last_write_time(file);
  EXPECT_EQ(written.size(), 5u);
  expect_hash(run_device_child(transform, with_cache(cache.path())));
  for (const auto& [file, time] : written) EXPECT_EQ(fs::last_write_time(file), time) << file;
}

// A binary holds ready functions for the kernels that had run only; the others must not be compiled by every process.
TEST(ProgramCacheFolder, TakesInKernelsThatLaterProcessesUseFirst) {
  const TemporaryFolder cache;
  expect_hash(run_device_child({"points", "100"}, with_cache(cache.path())));
  EXPECT_EQ(files_with(cache.path(), ".clbin").size(), 3u);  // one kernel, 2 self-tests
  EXPECT_EQ(expect_hash(run_device_child(transform, with_cache(cache.path()))), expected_hash());
  EXPECT_EQ(files_with(cache.path(), ".clbin").size(), 5u);
  EXPECT_EQ(expect_hash(run_device_child(transform, with_cache(cache.path()))), expected_hash());
}

TEST(ProgramCacheFolder, FourProcessesMayFillItAtOnce) {
  const TemporaryFolder cache;
  std::deque<ChildProcess> children;
  for (int i = 0; i < 4; ++i)
    children.emplace_back(device_child_command(transform), testing::device_options(with_cache(cache.path())));
  for (ChildProcess& child : children) EXPECT_EQ(expect_hash(testing::result_of(child)), expected_hash());
  EXPECT_EQ(files_with(cache.path(), ".clbin").size(), 5u);
  EXPECT_EQ(files_with(cache.path(), ".tmp").size(), 0u);
  EXPECT_EQ(expect_hash(run_device_child(transform, with_cache(cache.path()))), expected_hash());
}

// PoCL finds no device at all where its cache cannot be written; a temporary folder stands in and is cleared away.
TEST(ProgramCacheFolder, ThatCannotBeWrittenIsNoError) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "tmp");
  std::ofstream(folder / "file") << "in the way";
  Environment environment = with_cache(folder / "file" / "cache");
  environment["TMPDIR"] = (folder / "tmp").string();
  environment["HOME"] = (folder / "file").string();
  EXPECT_EQ(expect_hash(run_device_child(transform, environment)), expected_hash());
  EXPECT_TRUE(fs::is_empty(folder / "tmp"));
}

TEST(ProgramCacheFolder, ThatMayOnlyBeReadIsUsed) {
  const TemporaryFolder cache;
  expect_hash(run_device_child(transform, with_cache(cache.path())));
  const auto all = {cache.path(), cache / "programs"};
  for (const auto& folder : all) fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(expect_hash(run_device_child(transform, with_cache(cache.path()))), expected_hash());
  for (const auto& folder : all) fs::permissions(folder, fs::perms::owner_all);
}

TEST(ProgramCacheFolder, KernelLibrariesOfPoclDoNotMix) {
  const TemporaryFolder cache;
  expect_hash(run_device_child(transform, with_cache(cache.path())));
  Environment environment = with_cache(cache.path());
  environment["POCL_WORK_GROUP_METHOD"] = "loopvec";
  expect_hash(run_device_child(transform, environment));
  EXPECT_EQ(files_with(cache.path(), ".clbin").size(), 10u);
  // The number of threads changes no code.
  environment = with_cache(cache.path());
  environment["SLURM_CPUS_PER_TASK"] = "1";
  expect_hash(run_device_child(transform, environment));
  EXPECT_EQ(files_with(cache.path(), ".clbin").size(), 10u);
}

}  // namespace
}  // namespace morphcl
