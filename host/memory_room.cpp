#include "host/memory_room.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "morphcl/error.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t no_limit = std::uint64_t{1} << 60;  // version 1 writes "none" as a number of this size

std::uint64_t left_of(std::uint64_t limit, std::uint64_t used) { return limit > used ? limit - used : 0; }

std::string in_megabytes(std::uint64_t bytes) { return std::to_string(bytes / 1'000'000) + " MB"; }

std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::ifstream stream(file);
  std::uint64_t number = 0;
  return stream >> number ? std::optional(number) : std::nullopt;
}

// Of a file of lines "name number" or "name: number kB".
std::optional<std::uint64_t> value_in(const fs::path& file, std::string_view name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string word;
    std::uint64_t number = 0;
    if (words >> word >> number && word == name) return number;
  }
  return std::nullopt;
}

// The names of the files of a memory controller.
struct Controller {
  const char *limit, *used, *cached, *shared;  // the last two in memory.stat; shared memory is among what is cached
};
constexpr Controller version_1 = {"memory.limit_in_bytes", "memory.usage_in_bytes", "cache", "shmem"};
constexpr Controller version_2 = {"memory.max", "memory.current", "file", "shmem"};

struct Mount {
  fs::path root, point;  // what is mounted, seen from the hierarchy's own root, and where
};

std::optional<Mount> find_mount(const fs::path& root, std::string_view type, std::string_view option) {
  std::ifstream stream(root / "proc/self/mountinfo");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t dash = line.find(" - ");
    if (dash == std::string::npos) continue;
    std::istringstream before(line.substr(0, dash)), after(line.substr(dash + 3));
    std::string skipped, mounted, point, found_type, source, options;
    before >> skipped >> skipped >> skipped >> mounted >> point;
    after >> found_type >> source >> options;
    if (found_type != type) continue;
    if (option.empty() || ("," + options + ",").find("," + std::string(option) + ",") != std::string::npos)
      return Mount{mounted, point};
  }
  return std::nullopt;
}

// The path of this process's group in the hierarchy: of the line "0::PATH", or of the one that names the controller.
std::optional<std::string> group_path(const fs::path& root, std::string_view controller) {
  std::ifstream stream(root / "proc/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string names = "," + line.substr(first + 1, second - first - 1) + ",";
    if (controller.empty() ? names == ",," : names.find("," + std::string(controller) + ",") != std::string::npos)
      return line.substr(second + 1);
  }
  return std::nullopt;
}

void narrow(MemoryRoom& room, const fs::path& group, const Controller& names) {
  const auto limit = number_in(group / names.limit);
  if (!limit || *limit >= no_limit) return;
  const auto used = number_in(group / names.used);  // takes the system a millisecond, so it is not asked in vain
  const std::uint64_t cached = value_in(group / "memory.stat", names.cached).value_or(0);
  const std::uint64_t shared = value_in(group / "memory.stat", names.shared).value_or(0);
  const std::uint64_t left = left_of(*limit, left_of(used.value_or(0), left_of(cached, shared)));
  if (left < room.bytes) room = {left, "the memory limit of its control group, " + in_megabytes(*limit) + ","};
}

// From the process's group up to the top of what is mounted. In a container the path may be one of the host's.
void narrow_by(MemoryRoom& room, const fs::path& root, const char* type, const char* controller,
               const Controller& names) {
  const auto mount = find_mount(root, type, controller);
  const auto path = group_path(root, controller);
  if (!mount || !path) return;
  const fs::path below = fs::path(*path).lexically_relative(mount->root);
  const fs::path top = root / mount->point.relative_path();
  fs::path group = below.empty() || *below.begin() == ".." ? top : top / below;
  std::error_code failure;
  for (;; group = group.parent_path()) {
    if (fs::is_directory(group, failure)) narrow(room, group, names);
    const fs::path rest = group.lexically_relative(top);
    if (rest.empty() || rest == "." || *rest.begin() == "..") return;
  }
}

}  // namespace

MemoryRoom control_group_room(const fs::path& root) {
  MemoryRoom room;
  narrow_by(room, root, "cgroup2", "", version_2);
  narrow_by(room, root, "cgroup", "memory", version_1);
  return room;
}

MemoryRoom memory_room() {
  MemoryRoom room = control_group_room("/");
  const auto page = static_cast<std::uint64_t>(std::max(1L, sysconf(_SC_PAGESIZE)));
  std::ifstream statm("/proc/self/statm");
  std::uint64_t mapped = 0, resident = 0;
  statm >> mapped >> resident;
  rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    const std::uint64_t left = left_of(limit.rlim_cur, mapped * page);
    if (left < room.bytes) room = {left, "ulimit -v, " + in_megabytes(limit.rlim_cur) + ","};
  }
  const auto pages = sysconf(_SC_PHYS_PAGES);
  if (pages > 0) {
    const std::uint64_t memory = static_cast<std::uint64_t>(pages) * page, left = left_of(memory, resident * page);
    if (left < room.bytes) room = {left, "the machine, with " + in_megabytes(memory) + ","};
  }
  return room;
}

void require_memory(std::uint64_t bytes, const std::string& what, const std::string& remedy) {
  const MemoryRoom room = memory_room();
  if (bytes <= room.bytes) return;
  throw Error(ErrorKind::no_device, "",
              what + " takes some " + in_megabytes(bytes) + " of memory, and " + room.whose + " leaves " +
                  in_megabytes(room.bytes) + "; " + remedy);
}

}  // namespace morphcl
