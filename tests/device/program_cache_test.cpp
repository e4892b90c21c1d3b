// Processes that share a cache folder, damaged files in it, and folders that cannot be written.
#include "host/device/program_cache.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
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

const std::vector<std::string> points = {"points", "100"};  // one kernel
const std::vector<std::string> arrays = {"arrays", "100"};  // three kernels of one program, that of points among them
constexpr std::size_t points_programs = 3, arrays_programs = 5;  // kernels, and 2 self-tests

Environment with_cache(const fs::path& folder) { return {{"MORPHCL_CACHE_DIR", folder.string()}}; }

std::set<fs::path> files_with(const fs::path& folder, const std::string& extension) {
  std::set<fs::path> files;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder / "programs", missing))
    if (entry.path().extension() == extension) files.insert(entry.path());
  return files;
}

std::map<fs::path, fs::file_time_type> times_of_programs(const fs::path& folder) {
  std::map<fs::path, fs::file_time_type> times;
  for (const auto& file : files_with(folder, ".clfiles")) times[file] = fs::last_write_time(file);
  return times;
}

std::string expect_hash(const ChildResult& result) {
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NE(result.value("hash"), "") << result.output;
  return result.value("hash");
}

// What these tests share, since kernels take seconds to compile: hashes without any cache, which every other run must
// give, and a cache that a run of points has filled.
class ProgramCacheFolder : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    filled_ = std::make_unique<TemporaryFolder>();
    points_hash_ = expect_hash(run_device_child(points, {{"MORPHCL_CACHE_DIR", "-"}}));
    arrays_hash_ = expect_hash(run_device_child(arrays, {{"MORPHCL_CACHE_DIR", "-"}}));
    EXPECT_EQ(expect_hash(run_device_child(points, with_cache(filled_->path()))), points_hash_);
  }
  static void TearDownTestSuite() { filled_.reset(); }

  void fill() const { fs::copy(filled_->path(), cache_.path(), fs::copy_options::recursive); }
  void expect_points(const Environment& environment, const char* why = "") const {
    EXPECT_EQ(expect_hash(run_device_child(points, environment)), points_hash_) << why;
  }
  void expect_arrays(const Environment& environment) const {
    EXPECT_EQ(expect_hash(run_device_child(arrays, environment)), arrays_hash_);
  }
  const fs::path& cache() const { return cache_.path(); }

 private:
  static inline std::unique_ptr<TemporaryFolder> filled_;
  static inline std::string points_hash_, arrays_hash_;
  const TemporaryFolder cache_;
};

TEST_F(ProgramCacheFolder, HoldsProgramsAndVerdictAfterARun) {
  fill();
  EXPECT_EQ(files_with(cache(), ".clfiles").size(), points_programs);
  EXPECT_EQ(files_with(cache(), ".verdict").size(), 1u);
  EXPECT_EQ(files_with(cache(), ".tmp").size(), 0u);
  // A second run uses them as they are; PoCL's own cache went with the first.
  const auto written = times_of_programs(cache());
  EXPECT_FALSE(fs::exists(cache() / "pocl"));
  expect_points(with_cache(cache()));
  EXPECT_EQ(times_of_programs(cache()), written);
}

TEST_F(ProgramCacheFolder, DamagedFilesAreIgnoredAndReplaced) {
  fill();
  const auto cut = [](const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); };
  const auto empty = [](const fs::path& file) { fs::resize_file(file, 0); };
  const auto overwrite = [](const fs::path& file) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(fs::file_size(file) / 2)).write("\xde\xad\xbe\xef", 4);
  };
  // In turn: which of them befalls a file does not matter, as disk_cache_test.cpp shows.
  const std::function<void(const fs::path&)> damages[] = {cut, empty, overwrite};
  std::size_t next = 0;
  for (const char* kind : {".clfiles", ".verdict"})
    for (const auto& file : files_with(cache(), kind)) damages[next++ % std::size(damages)](file);
  expect_points(with_cache(cache()));
  // Each was stored anew, so that one more run rewrites nothing.
  const auto written = times_of_programs(cache());
  EXPECT_EQ(written.size(), points_programs);
  expect_points(with_cache(cache()));
  EXPECT_EQ(times_of_programs(cache()), written);
}

// A binary holds ready functions for the kernels that had run only; the others must not be compiled by every process.
TEST_F(ProgramCacheFolder, TakesInKernelsThatLaterProcessesUseFirst) {
  fill();
  expect_arrays(with_cache(cache()));
  EXPECT_EQ(files_with(cache(), ".clfiles").size(), arrays_programs);
  const auto written = times_of_programs(cache());
  expect_arrays(with_cache(cache()));
  EXPECT_EQ(times_of_programs(cache()), written);
}

TEST_F(ProgramCacheFolder, SeveralProcessesMayFillItAtOnce) {
  std::deque<ChildProcess> children;
  for (int i = 0; i < 3; ++i)
    children.emplace_back(device_child_command(points), testing::device_options(with_cache(cache())));
  std::set<std::string> hashes;
  for (ChildProcess& child : children) hashes.insert(expect_hash(testing::result_of(child)));
  EXPECT_EQ(hashes.size(), 1u);
  EXPECT_EQ(files_with(cache(), ".clfiles").size(), points_programs);
  EXPECT_EQ(files_with(cache(), ".tmp").size(), 0u);
  expect_points(with_cache(cache()));
}

// Where PoCL's folder is the user's, nothing is taken out of it: binaries are kept, and loaded before files are.
TEST_F(ProgramCacheFolder, HoldsBinariesWherePoclsFolderIsTheUsers) {
  fill();
  const TemporaryFolder pocl;
  Environment environment = with_cache(cache());
  environment["POCL_CACHE_DIR"] = pocl.path().string();
  expect_points(environment);
  EXPECT_EQ(files_with(cache(), ".clbin").size(), 1u);  // the self-test is known to pass
  const auto files = times_of_programs(cache());
  for (const auto& [file, time] : files) fs::remove(file);
  expect_points(with_cache(cache()));
  EXPECT_EQ(times_of_programs(cache()).size(), 0u) << "nothing had to be compiled";
}

// PoCL finds no device at all where its cache cannot be written; a temporary folder stands in and is cleared away.
TEST_F(ProgramCacheFolder, ThatCannotBeWrittenIsNoError) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "tmp");
  std::ofstream(folder / "file") << "in the way";
  Environment environment = with_cache(folder / "file" / "cache");
  environment["TMPDIR"] = (folder / "tmp").string();
  environment["HOME"] = (folder / "file").string();
  expect_points(environment);
  EXPECT_TRUE(fs::is_empty(folder / "tmp"));
}

TEST_F(ProgramCacheFolder, ThatMayOnlyBeReadIsUsed) {
  fill();
  const auto all = {cache(), cache() / "programs"};
  for (const auto& folder : all) fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  const auto written = times_of_programs(cache());
  expect_points(with_cache(cache()));
  EXPECT_EQ(times_of_programs(cache()), written);
  for (const auto& folder : all) fs::permissions(folder, fs::perms::owner_all);
}

TEST_F(ProgramCacheFolder, KernelLibrariesOfPoclDoNotMix) {
  fill();
  Environment environment = with_cache(cache());
  environment["POCL_WORK_GROUP_METHOD"] = "loopvec";
  expect_points(environment);
  EXPECT_EQ(files_with(cache(), ".clfiles").size(), 2 * points_programs);
  // The number of threads changes no code.
  environment = with_cache(cache());
  environment["SLURM_CPUS_PER_TASK"] = "1";
  expect_points(environment);
  EXPECT_EQ(files_with(cache(), ".clfiles").size(), 2 * points_programs);
}

}  // namespace
}  // namespace morphcl
