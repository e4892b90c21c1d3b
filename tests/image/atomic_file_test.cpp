// Whole or not at all: full disks, size limits, folders that cannot be made, killed writers.
#include "host/image/atomic_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <functional>

#include "host/end_process.hpp"
#include "host/temporary_file.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

ErrorKind kind_of_failure(const std::function<void()>& action, const std::string& path) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), path) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << path << " was written";
  return ErrorKind::internal;
}

const std::vector<char> some_bytes{'w', 'h', 'o', 'l', 'e'};
const std::vector<char> megabyte(1 << 20, 'm');

TEST(AtomicFile, StandsUnderItsNameAlone) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a", some_bytes);
  EXPECT_EQ(bytes_of(folder / "a"), some_bytes);
  write_file_atomically(folder / "a", megabyte);  // replaces
  EXPECT_EQ(bytes_of(folder / "a"), megabyte);
  EXPECT_EQ(folder.names(), std::set<std::string>{"a"});
}

TEST(AtomicFile, MissingFoldersAreMade) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "x/y/z/a", some_bytes);
  EXPECT_EQ(bytes_of(folder / "x/y/z/a"), some_bytes);
}

TEST(AtomicFile, RelativeNameWithoutFolderIsInTheCurrentFolder) {
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  write_file_atomically("a", some_bytes);
  std::filesystem::current_path(before);
  EXPECT_EQ(folder.names(), std::set<std::string>{"a"});
}

TEST(AtomicFile, LongestNameOfTheFileSystemWorks) {
  const TemporaryFolder folder;
  const std::string name(255, 'n');
  write_file_atomically(folder / name, some_bytes);
  EXPECT_EQ(folder.names(), std::set<std::string>{name});
}

TEST(AtomicFile, FolderBelowAFileCannotBeCreated) {
  const TemporaryFolder folder;
  write_bytes(folder / "file", some_bytes);
  const std::string path = folder / "file/a.exr";
  EXPECT_EQ(kind_of_failure([&] { write_file_atomically(path, some_bytes); }, path), ErrorKind::cannot_create);
  EXPECT_EQ(kind_of_failure([&] { check_can_create(path); }, path), ErrorKind::cannot_create);
  EXPECT_EQ(kind_of_failure([&] { write_exr(path, disc_frame(4, 4), {}, "zip"); }, path), ErrorKind::cannot_create);
}

TEST(AtomicFile, FolderInProcCannotBeCreated) {
  const std::string path = "/proc/nope/a.exr";
  EXPECT_EQ(kind_of_failure([&] { write_file_atomically(path, some_bytes); }, path), ErrorKind::cannot_create);
}

// Pipes stand for devices here: a test that fails must not replace one.
TEST(AtomicFile, PipesAndFoldersAreNotReplaced) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_directory(folder / "folder");
  for (const std::filesystem::path& path : {folder / "pipe", folder / "folder"})
    EXPECT_EQ(kind_of_failure([&] { write_file_atomically(path, some_bytes); }, path), ErrorKind::cannot_create);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"pipe", "folder"}));
}

TEST(AtomicFile, CheckLeavesOnlyTheFolder) {
  const TemporaryFolder folder;
  check_can_create(folder / "x/a");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "x"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "x"));
}

// What a full disk has to leave behind: an older file as it was, and nothing else.
void expect_write_without_room_to_fail(const TemporaryFolder& folder) {
  const std::string old_file = folder / "old", frame = folder / "new.exr";
  EXPECT_EQ(kind_of_failure([&] { write_file_atomically(old_file, megabyte); }, old_file), ErrorKind::write_failed);
  const FrameBuffer pixels = arbitrary_frame(600, 400, {Channel::color, Channel::depth});
  EXPECT_EQ(kind_of_failure([&] { write_exr(frame, pixels, {}, "none"); }, frame), ErrorKind::write_failed);
  EXPECT_EQ(folder.names(), std::set<std::string>{"old"});
  EXPECT_EQ(bytes_of(old_file), some_bytes);
}

// No file of this process may grow beyond 100 kB while this lives.
class FileSizeLimit {
 public:
  FileSizeLimit() {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = 100'000;
    setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = signal(SIGXFSZ, SIG_IGN);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(AtomicFile, FileSizeLimitFailsTheWriteAndLeavesNothing) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "old", some_bytes);
  const FileSizeLimit limit;
  expect_write_without_room_to_fail(folder);
}

// A disk of 256 KiB: only root may mount one; the size limit above stands for it elsewhere.
class FullDisk : public testing::Test {
 protected:
  FullDisk() : mounted_(mount("none", folder_.path().c_str(), "tmpfs", 0, "size=256k") == 0) {}
  ~FullDisk() override {
    if (mounted_) umount(folder_.path().c_str());
  }
  TemporaryFolder folder_;
  const bool mounted_;
};

TEST_F(FullDisk, FailsTheWriteAndLeavesNothing) {
  if (!mounted_) return;
  write_file_atomically(folder_ / "old", some_bytes);
  expect_write_without_room_to_fail(folder_);
  try {
    write_file_atomically(folder_ / "new", megabyte);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), std::strerror(ENOSPC));
  }
}

// As in a container that is started again: the names that this process is about to use are there.
TEST(AtomicFile, WhatAnEarlierProcessOfOurNumberLeftIsNotInTheWay) {
  const TemporaryFolder folder;
  const std::string frame = folder / "shot.0007.exr";
  for (unsigned number = 0; number < 200; ++number) write_bytes(temporary_name(frame, getpid(), number), some_bytes);
  write_file_atomically(frame, some_bytes);
  EXPECT_EQ(bytes_of(frame), some_bytes);
  EXPECT_EQ(remove_stale_temporaries(folder / "shot."), 200) << "this process lives, but it does not hold them";
  EXPECT_EQ(folder.names(), std::set<std::string>{"shot.0007.exr"});
}

std::string only_temporary_in(const TemporaryFolder& folder) {
  for (const std::string& name : folder.names())
    if (name.ends_with(".morphcl-tmp")) return name;
  return "";
}

// Starts a process that is stopped in the middle of writing "shot.0007.exr".
pid_t start_stuck_writer(const TemporaryFolder& folder) {
  const pid_t pid = fork();
  if (pid == 0) {
    // Writing more than the limit raises SIGXFSZ; stopping there leaves the temporary file in place and locked.
    signal(SIGXFSZ, [](int) { raise(SIGSTOP); });
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_file_atomically(folder / "shot.0007.exr", megabyte);
    } catch (...) {
    }
    _exit(0);
  }
  int status = 0;
  waitpid(pid, &status, WUNTRACED);
  EXPECT_TRUE(WIFSTOPPED(status));
  return pid;
}

void kill_and_wait(pid_t pid) {
  kill(pid, SIGKILL);
  waitpid(pid, nullptr, 0);
}

TEST(StaleTemporaries, OfKilledProcessesAreRemovedAndOfLivingOnesKept) {
  const TemporaryFolder folder;
  const pid_t pid = start_stuck_writer(folder);
  ASSERT_NE(only_temporary_in(folder), "");
  EXPECT_EQ(remove_stale_temporaries(folder / "shot."), 0) << "the writer lives";
  kill_and_wait(pid);
  ASSERT_NE(only_temporary_in(folder), "") << "a killed process cannot clean up";
  EXPECT_EQ(remove_stale_temporaries(folder / "other."), 0) << "another pattern";
  EXPECT_EQ(remove_stale_temporaries(folder / "shot."), 1);
  EXPECT_TRUE(folder.names().empty());
}

TEST(StaleTemporaries, LockedOnesAndThoseOfOtherHostsAreKept) {
  const TemporaryFolder folder;
  kill_and_wait(start_stuck_writer(folder));
  const std::string temporary = only_temporary_in(folder);
  const int file = open((folder / temporary).c_str(), O_RDONLY);
  ASSERT_EQ(flock(file, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(remove_stale_temporaries(folder / "shot."), 0) << "locked: its process has another number elsewhere";
  close(file);
  const std::string elsewhere = ".shot.0008.exr.some-other-host.999999999.0.morphcl-tmp";
  write_bytes(folder / elsewhere, some_bytes);
  EXPECT_EQ(remove_stale_temporaries(folder / "shot."), 1);
  EXPECT_EQ(folder.names(), std::set<std::string>{elsewhere});
}

TEST(AtomicFile, IsNotLeftBehindByAProcessThatEndsAtOnce) {
  const TemporaryFolder folder;
  const pid_t pid = fork();
  if (pid == 0) {
    const TemporaryFile file((folder / "a").string(), 0666);
    end_process(file.error());
  }
  int status = -1;
  waitpid(pid, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(folder.names(), std::set<std::string>{});
}

// Who opens the files of this process as closed standard streams would have it must not find a frame there.
TEST(AtomicFile, IsNeverOneOfTheStandardStreams) {
  const TemporaryFolder folder;
  const pid_t pid = fork();
  if (pid == 0) {
    for (const int stream : {0, 1, 2}) close(stream);
    const TemporaryFile file((folder / "a").string(), 0666);
    _exit(file.error() != 0 || write(0, "x", 1) == 1 || write(1, "x", 1) == 1 || write(2, "x", 1) == 1);
  }
  int status = -1;
  waitpid(pid, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(StaleTemporaries, OtherFilesAndMissingFoldersAreNoTrouble) {
  const TemporaryFolder folder;
  const std::set<std::string> names{
      "shot.0001.exr",      ".shot.morphcl-tmp",        ".shot.a.b.c.morphcl-tmp",
      ".x.morphcl-tmp.exr", ".shot.h.-1.0.morphcl-tmp", ".shot.h.99999999999999999999.0.morphcl-tmp"};
  for (const std::string& name : names) write_bytes(folder / name, some_bytes);
  EXPECT_EQ(remove_stale_temporaries(folder / "shot."), 0);
  EXPECT_EQ(folder.names(), names);
  EXPECT_EQ(remove_stale_temporaries(folder / "missing/shot."), 0);
}

}  // namespace
}  // namespace morphcl
