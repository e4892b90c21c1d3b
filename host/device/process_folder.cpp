#include "host/device/process_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <vector>

namespace morphcl {

namespace fs = std::filesystem;

namespace {

// Locked before it gets the name that others look at, so that they never see an unlocked owner of a living process.
bool lock_as_owner(const fs::path& folder) {
  const fs::path unnamed = folder / "owner.new";
  const int file = open(unnamed.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);  // kept open until the process ends
  return file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0 && rename(unnamed.c_str(), (folder / "owner").c_str()) == 0;
}

bool is_abandoned(const fs::path& folder) {
  struct stat status = {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != geteuid()) return false;
  const int file = open((folder / "owner").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return false;
  const bool abandoned = flock(file, LOCK_EX | LOCK_NB) == 0;
  close(file);
  return abandoned;
}

void remove_abandoned(const fs::path& parent, const std::string& prefix) {
  std::error_code failure;
  std::vector<fs::path> abandoned;
  for (fs::directory_iterator entry(parent, failure), end; !failure && entry != end; entry.increment(failure))
    if (entry->path().filename().string().starts_with(prefix) && is_abandoned(entry->path()))
      abandoned.push_back(entry->path());
  for (const fs::path& folder : abandoned) fs::remove_all(folder, failure);
}

struct Owned {
  fs::path folder;
  pid_t process = 0;

  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() {
    std::error_code failure;
    // A forked child that exits must leave its parent's folder alone.
    if (!folder.empty() && process == getpid()) fs::remove_all(folder, failure);
  }
};

}  // namespace

fs::path make_process_folder(const fs::path& parent, const std::string& prefix) {
  static std::vector<std::unique_ptr<Owned>> owned;
  if (parent.empty()) return {};
  remove_abandoned(parent, prefix + "-");
  std::string name = (parent / (prefix + "-XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) return {};
  auto made = std::make_unique<Owned>();
  made->folder = name;
  made->process = getpid();
  if (!lock_as_owner(name)) return {};
  owned.push_back(std::move(made));
  return name;
}

}  // namespace morphcl
