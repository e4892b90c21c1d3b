#include "host/image/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>

#include "morphcl/error.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view suffix = ".morphcl-tmp";
// Together with host, numbers and suffix a name stays below the 255 bytes that file systems allow.
constexpr std::size_t longest_name_part = 100;

std::string reason(int error) { return std::strerror(error); }

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

std::string temporary_path(const std::string& path) {
  static std::atomic<unsigned> count{0};
  const std::string name = fs::path(path).filename().string().substr(0, longest_name_part);
  return (folder_of(path) / fmt::format(".{}.{}.{}.{}{}", name, host_name(), getpid(), count++, suffix)).string();
}

// The file under its temporary name, locked; removed again unless it was published.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path) : path_(path), temporary_(temporary_path(path)) {
    struct stat status{};
    if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
      throw Error(ErrorKind::cannot_create, path, "is there already and is not a regular file; give another name");
    std::error_code error;
    fs::create_directories(folder_of(path), error);
    if (error)
      throw Error(ErrorKind::cannot_create, path, fmt::format("its folder cannot be made: {}", reason(error.value())));
    file_ = open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ < 0)
      throw Error(ErrorKind::cannot_create, path, fmt::format("the file cannot be created: {}", reason(errno)));
    flock(file_, LOCK_EX | LOCK_NB);  // where a file system has no locks, the process number has to do
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!published_) unlink(temporary_.c_str());
    close(file_);
  }

  void write_all(std::span<const char> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(file_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) throw Error(ErrorKind::write_failed, path_, reason(written < 0 ? errno : EIO));
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    // Network file systems report a full disk only here.
    if (fsync(file_) != 0) throw Error(ErrorKind::write_failed, path_, reason(errno));
  }

  void publish() {
    if (rename(temporary_.c_str(), path_.c_str()) != 0)
      throw Error(ErrorKind::write_failed, path_, fmt::format("cannot be renamed into place: {}", reason(errno)));
    published_ = true;
    const int folder = open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    fsync(folder);  // the file itself is safe already; some file systems cannot flush a folder
    close(folder);
  }

 private:
  std::string path_, temporary_;
  int file_ = -1;
  bool published_ = false;
};

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

bool is_locked(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return false;
  const bool locked = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(file);
  return locked;
}

}  // namespace

void write_file_atomically(const std::string& path, std::span<const char> bytes) {
  TemporaryFile file(path);
  file.write_all(bytes);
  file.publish();
}

void check_can_create(const std::string& path) { TemporaryFile probe(path); }

int remove_stale_temporaries(const std::string& path_prefix) {
  int removed = 0;
  const std::string prefix = fs::path(path_prefix).filename().string().substr(0, longest_name_part);
  std::error_code error;
  for (fs::directory_iterator entry(folder_of(path_prefix), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::optional<Owner> owner = owner_of(entry->path().filename().string());
    if (!owner || !owner->name.starts_with(prefix)) continue;
    // Processes of other containers have other numbers, so the lock has to be free as well.
    const bool gone = kill(owner->pid, 0) != 0 && errno == ESRCH;
    const std::string temporary = entry->path().string();
    if (gone && !is_locked(temporary) && unlink(temporary.c_str()) == 0) ++removed;
  }
  return removed;
}

}  // namespace morphcl
