#include "host/device/process_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "host/leftovers.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t random_letters = 6;  // that mkdtemp() puts in

bool stands_under(int file, const fs::path& name) {
  struct stat opened = {}, named = {};
  return fstat(file, &opened) == 0 && lstat(name.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

// Locked before it gets the name that says so; false when another process took the folder for abandoned meanwhile.
bool lock_as_owner(const fs::path& folder) {
  const fs::path unnamed = folder / "owner.new", named = folder / "owner";
  const int file = open(unnamed.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);  // kept open until the process ends
  if (file < 0) return false;
  if (flock(file, LOCK_EX | LOCK_NB) == 0 && rename(unnamed.c_str(), named.c_str()) == 0 && stands_under(file, named))
    return true;
  close(file);
  return false;
}

// The lock is held while the folder goes, so that a process that is about to own it finds out.
void remove_if_abandoned(const fs::path& folder) {
  struct stat status = {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != geteuid()) return;
  int file = open((folder / "owner").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) file = open((folder / "owner.new").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  std::error_code failure;
  if (file < 0) {
    fs::remove_all(folder, failure);  // killed before it had an owner, or while it was removed
    return;
  }
  if (flock(file, LOCK_EX | LOCK_NB) == 0) fs::remove_all(folder, failure);
  close(file);
}

void remove_abandoned(const fs::path& parent, const std::string& prefix) {
  std::error_code failure;
  std::vector<fs::path> folders;
  for (fs::directory_iterator entry(parent, failure), end; !failure && entry != end; entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(prefix) && name.size() == prefix.size() + random_letters) folders.push_back(entry->path());
  }
  for (const fs::path& folder : folders) remove_if_abandoned(folder);
}

struct Owned {
  Leftover folder;
  pid_t process = getpid();

  explicit Owned(const std::string& path) : folder(path) {}
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    std::error_code failure;
    // A forked child that exits must leave its parent's folder alone.
    if (process == getpid()) fs::remove_all(folder.path(), failure);
  }
};

}  // namespace

fs::path make_process_folder(const fs::path& parent, const std::string& prefix) {
  static std::vector<std::unique_ptr<Owned>> owned;
  if (parent.empty()) return {};
  remove_abandoned(parent, prefix + "-");
  for (int attempt = 0; attempt < 10; ++attempt) {
    std::string name = (parent / (prefix + "-" + std::string(random_letters, 'X'))).string();
    if (mkdtemp(name.data()) == nullptr) return {};
    auto made = std::make_unique<Owned>(name);
    if (!lock_as_owner(name)) continue;
    owned.push_back(std::move(made));
    return name;
  }
  return {};
}

}  // namespace morphcl
