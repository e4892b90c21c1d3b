#include "host/device/process_folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "host/end_process.hpp"
#include "tests/support/exit_code_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::testing {
namespace {

namespace fs = std::filesystem;
using test_support::TemporaryFolder;

TEST(ProcessFolder, IsFreshAndForThisUserOnly) {
  const TemporaryFolder parent;
  const fs::path first = make_process_folder(parent.path(), "own"), second = make_process_folder(parent.path(), "own");
  EXPECT_NE(first, second);
  for (const fs::path& folder : {first, second}) {
    EXPECT_TRUE(folder.filename().string().starts_with("own-"));
    EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
  }
}

TEST(ProcessFolder, GoesWithItsProcessButNotWithAForkedChild) {
  const TemporaryFolder parent;
  const pid_t owner = fork();
  if (owner == 0) {
    std::ofstream(make_process_folder(parent.path(), "own") / "file") << "content";
    const pid_t child = fork();
    if (child == 0) std::exit(0);
    waitpid(child, nullptr, 0);
    if (fs::is_empty(parent.path())) _exit(1);
    std::exit(0);
  }
  int status = -1;
  waitpid(owner, &status, 0);
  EXPECT_EQ(status, 0) << "the child removed its parent's folder";
  EXPECT_TRUE(fs::is_empty(parent.path()));
}

// As the driver's compiler does it: folders, with those above them, and files in them.
void write_for_ever(const fs::path& folder) {
  for (int i = 0;; ++i) {
    const fs::path below = folder / std::to_string(i % 100) / "below";
    std::error_code failure;
    fs::create_directories(below, failure);
    std::ofstream(below / std::to_string(i)) << i;
  }
}

TEST(ProcessFolder, GoesWithAProcessThatEndsWhileThreadsWriteIntoIt) {
  const TemporaryFolder parent;
  for (int round = 0; round < 10; ++round) {
    const int code = test_support::exit_code_of([&] {
      const fs::path folder = make_process_folder(parent.path(), "own");
      for (int i = 0; i < 3; ++i) std::thread(write_for_ever, folder).detach();
      while (!fs::exists(folder / "99")) std::this_thread::yield();
      end_process(7);
    });
    EXPECT_EQ(code, 7);
    ASSERT_EQ(parent.names(), std::set<std::string>{}) << "round " << round;
  }
}

TEST(ProcessFolder, StaysWhereAForkedChildEndsAtOnce) {
  const TemporaryFolder parent;
  EXPECT_EQ(test_support::exit_code_of([&] {
              const fs::path folder = make_process_folder(parent.path(), "own");
              const int code = test_support::exit_code_of([] { end_process(7); });
              _exit(fs::exists(folder) ? code : 1);
            }),
            7);
}

TEST(ProcessFolder, OfAKilledProcessIsRemovedByTheNext) {
  const TemporaryFolder parent;
  const pid_t owner = fork();
  if (owner == 0) {
    make_process_folder(parent.path(), "own");
    _exit(0);  // as when it is killed: nothing is cleaned up
  }
  waitpid(owner, nullptr, 0);
  ASSERT_FALSE(fs::is_empty(parent.path()));
  const fs::path next = make_process_folder(parent.path(), "own");
  EXPECT_EQ(std::distance(fs::directory_iterator(parent.path()), fs::directory_iterator()), 1);
  EXPECT_TRUE(fs::exists(next));
}

TEST(ProcessFolder, OfAProcessThatWasKilledWithoutAnOwnersFileIsRemovedByTheNext) {
  const TemporaryFolder parent;
  fs::create_directory(parent / "own-before");   // it had no owner yet
  parent.write("own-atexit/cache/program", "");  // its removal had begun
  parent.write("own-naming/owner.new", "");
  const fs::path next = make_process_folder(parent.path(), "own");
  EXPECT_EQ(parent.names(), std::set<std::string>{next.filename().string()});
}

TEST(ProcessFolder, OfALivingProcessAndFoldersThatAreNotOursStay) {
  const TemporaryFolder parent;
  fs::create_directory(parent / "own-living");
  const int living = open((parent / "own-living" / "owner").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(living, LOCK_EX | LOCK_NB), 0);
  fs::create_directory(parent / "own-without-owner");
  fs::create_directory(parent / "other-prefix");
  std::ofstream(parent / "other-prefix" / "owner") << "";
  fs::create_directory_symlink(parent / "other-prefix", parent / "own-link");
  make_process_folder(parent.path(), "own");
  for (const char* name : {"own-living", "own-without-owner", "other-prefix", "own-link"})
    EXPECT_TRUE(fs::exists(parent / name)) << name;
  close(living);
  make_process_folder(parent.path(), "own");
  EXPECT_FALSE(fs::exists(parent / "own-living"));
}

TEST(ProcessFolder, WhereNoneCanBeMadeIsEmpty) {
  EXPECT_EQ(make_process_folder("/proc/none", "own"), fs::path());
  EXPECT_EQ(make_process_folder("", "own"), fs::path());
}

}  // namespace
}  // namespace morphcl::testing
