#include "host/temporary_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <string_view>

namespace morphcl {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view suffix = ".morphcl-tmp";
// Together with host, numbers and suffix a name stays below the 255 bytes that file systems allow.
constexpr std::size_t longest_name_part = 100;
constexpr int max_names_tried = 10'000;

std::string host_name() {
  std::array<char, 65> name{};
  gethostname(name.data(), name.size() - 1);
  std::string host(name.data());
  for (char& c : host)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
  return host;
}

fs::path folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

std::string name_part(const std::string& path) {
  return fs::path(path).filename().string().substr(0, longest_name_part);
}

// As open(), but never one of the numbers of stdin, stdout and stderr, where a program that knows nothing of this file
// may print.
int open_above_standard(const char* path, int flags, mode_t mode) {
  int file = -1;
  do {
    file = open(path, flags | O_CLOEXEC, mode);
  } while (file < 0 && errno == EINTR);
  if (file < 0 || file > STDERR_FILENO) return file;
  const int above = fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int failure = errno;
  close(file);
  errno = failure;
  return above;
}

enum class Lock { taken, held, none };  // none: the file system has no locks

Lock take_lock(int file) {
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return Lock::taken;
  return errno == EWOULDBLOCK ? Lock::held : Lock::none;
}

bool stands_under(int file, const std::string& name) {
  struct stat opened{}, named{};
  return fstat(file, &opened) == 0 && lstat(name.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

// NAME and PID of a temporary file of this host, from its own name.
struct Owner {
  std::string name;
  pid_t pid;
};
std::optional<Owner> owner_of(const std::string& file_name) {
  std::string_view rest = file_name;
  if (!rest.starts_with('.') || !rest.ends_with(suffix)) return std::nullopt;
  rest.remove_prefix(1);
  rest.remove_suffix(suffix.size());
  std::array<std::string_view, 3> fields;  // number, process, host
  for (std::string_view& field : fields) {
    const std::size_t dot = rest.rfind('.');
    if (dot == std::string_view::npos) return std::nullopt;
    field = rest.substr(dot + 1);
    rest = rest.substr(0, dot);
  }
  pid_t pid = 0;
  const auto [end, error] = std::from_chars(fields[1].begin(), fields[1].end(), pid);
  if (error != std::errc() || end != fields[1].end() || pid <= 0 || fields[2] != host_name()) return std::nullopt;
  return Owner{std::string(rest), pid};
}

// While the lock is held here: who makes a file of this name meanwhile finds it locked, and takes another one.
bool remove_if_abandoned(const std::string& temporary, pid_t pid) {
  const int file = open(temporary.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return false;
  const Lock lock = take_lock(file);
  const bool gone = lock == Lock::none ? kill(pid, 0) != 0 && errno == ESRCH : lock == Lock::taken;
  const bool removed = gone && unlink(temporary.c_str()) == 0;
  close(file);
  return removed;
}

}  // namespace

std::string temporary_name(const std::string& path, pid_t process, unsigned number) {
  std::string name = "." + name_part(path) + "." + host_name() + "." + std::to_string(process) + ".";
  name += std::to_string(number);
  name += suffix;
  return (folder_of(path) / name).string();
}

int TemporaryFile::last_error() { return errno != 0 ? errno : EIO; }

// False where the name is another's; error_ where no file can be made at all.
bool TemporaryFile::take_name(const std::string& name, mode_t mode) {
  int failure = 0;
  temporary_.emplace(name, [&] {
    file_ = open_above_standard(name.c_str(), O_CREAT | O_EXCL | O_WRONLY, mode);
    failure = errno;
  });
  errno = failure;
  if (file_ >= 0) {
    if (take_lock(file_) != Lock::held && stands_under(file_, name)) return true;
    close(file_);  // taken for a stale one before it was locked
    file_ = -1;
  } else if (errno != EEXIST) {
    fails();
  }
  temporary_.reset();
  return false;
}

TemporaryFile::TemporaryFile(const std::string& path, mode_t mode) : path_(path) {
  static std::atomic<unsigned> count{0};
  for (int i = 0; i < max_names_tried && error_ == 0; ++i)
    if (take_name(temporary_name(path, getpid(), count++), mode)) return;
  if (error_ == 0) error_ = EEXIST;
}

TemporaryFile::~TemporaryFile() {
  if (file_ < 0) return;
  if (!published_) unlink(temporary_->path().c_str());
  close(file_);
}

bool TemporaryFile::write_all(std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = EIO;
    if (written <= 0) return fails();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

bool TemporaryFile::flush() {
  while (fsync(file_) != 0)
    if (errno != EINTR) return fails();
  return true;
}

bool TemporaryFile::publish() {
  if (rename(temporary_->path().c_str(), path_.c_str()) != 0) return fails();
  published_ = true;
  return true;
}

void flush_folder_of(const std::string& path) {
  const int folder = open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  while (fsync(folder) != 0 && errno == EINTR) {
  }
  close(folder);
}

int remove_stale_temporaries(const std::string& path_prefix) {
  int removed = 0;
  const std::string prefix = name_part(path_prefix);
  std::error_code error;
  for (fs::directory_iterator entry(folder_of(path_prefix), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::optional<Owner> owner = owner_of(entry->path().filename().string());
    if (owner && owner->name.starts_with(prefix) && remove_if_abandoned(entry->path().string(), owner->pid)) ++removed;
  }
  return removed;
}

}  // namespace morphcl
