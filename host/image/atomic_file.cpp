#include "host/image/atomic_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "host/temporary_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

Error cannot_create(const std::string& path, std::string_view why) {
  return Error(ErrorKind::cannot_create, path, why);
}

void prepare_place(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw cannot_create(path, fmt::format("its folder cannot be made: {}", std::strerror(error.value())));
  struct stat status{};
  const bool there = stat(path.c_str(), &status) == 0;
  if (there && !S_ISREG(status.st_mode))
    throw cannot_create(path, "is there already and is not a regular file; give another name");
  if (!there && errno != ENOENT) throw cannot_create(path, fmt::format("cannot be written: {}", std::strerror(errno)));
}

void check_made(const TemporaryFile& file, const std::string& path) {
  if (file.error() != 0)
    throw cannot_create(path, fmt::format("the file cannot be created: {}", std::strerror(file.error())));
}

}  // namespace

void write_file_atomically(const std::string& path, std::span<const char> bytes) {
  constexpr int max_attempts = 3;  // a folder may go between two steps, and is made again
  for (int attempt = 1;; ++attempt) {
    const bool last = attempt == max_attempts;
    prepare_place(path);
    TemporaryFile file(path, 0666);
    if (!last && file.error() == ENOENT) continue;
    check_made(file, path);
    if (!file.write_all(bytes) || !file.flush())
      throw Error(ErrorKind::write_failed, path, std::strerror(file.error()));
    if (file.publish()) break;
    if (last || file.error() != ENOENT)
      throw Error(ErrorKind::write_failed, path,
                  fmt::format("cannot be renamed into place: {}", std::strerror(file.error())));
  }
  flush_folder_of(path);
}

void check_name_length(const std::string& path) {
  struct stat status{};
  if (lstat(path.c_str(), &status) != 0 && errno == ENAMETOOLONG) throw cannot_create(path, std::strerror(errno));
}

void check_can_create(const std::string& path) {
  prepare_place(path);
  check_made(TemporaryFile(path, 0666), path);
}

}  // namespace morphcl
