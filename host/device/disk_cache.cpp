#include "host/device/disk_cache.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>

#include "host/temporary_file.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

constexpr char magic[8] = {'m', 'o', 'r', 'p', 'h', 'c', 'l', 1};
// A hundred times the largest program seen; what claims more is no work of ours.
constexpr std::uint64_t max_content_bytes = std::uint64_t{256} << 20;

struct Header {
  char magic[8];
  std::uint64_t key_high, key_low, length, checksum;
};
static_assert(sizeof(Header) == 40 && std::is_trivially_copyable_v<Header>, "the header is written as it stands");

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  ~File() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool is_open() const { return descriptor_ >= 0; }

  // The size of a regular file that nobody but this user and root can have written, as it holds native code; nothing
  // for others, and for folders, pipes and devices.
  std::optional<std::uint64_t> size() const {
    struct stat status;
    if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    if (status.st_uid != geteuid() && status.st_uid != 0) return std::nullopt;
    if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0) return std::nullopt;
    return static_cast<std::uint64_t>(status.st_size);
  }

  bool read_all(void* data, std::size_t bytes) const {
    for (auto* at = static_cast<unsigned char*>(data); bytes > 0;) {
      const ssize_t got = read(descriptor_, at, bytes);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      at += got;
      bytes -= static_cast<std::size_t>(got);
    }
    return true;
  }

 private:
  int descriptor_;
};

Header header_for(const CacheKey& key, std::span<const unsigned char> content) {
  Header header{{}, key.high, key.low, content.size(), XXH3_64bits(content.data(), content.size())};
  std::memcpy(header.magic, magic, sizeof magic);
  return header;
}

}  // namespace

std::string CacheKey::hex() const { return fmt::format("{:016x}{:016x}", high, low); }

CacheKey cache_key(std::span<const std::string> parts) {
  std::string text;
  for (const std::string& part : parts) text += fmt::format("{}:{},", part.size(), part);
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return {hash.high64, hash.low64};
}

DiskCache::DiskCache(std::optional<fs::path> folder, std::string suffix)
    : folder_(std::move(folder)), suffix_(std::move(suffix)) {}

fs::path DiskCache::file_of(const CacheKey& key) const { return *folder_ / (key.hex() + "." + suffix_); }

std::optional<std::vector<unsigned char>> DiskCache::load(const CacheKey& key) const {
  if (!folder_) return std::nullopt;
  // Non-blocking, so that a pipe of that name cannot hold us up.
  const File file(open(file_of(key).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) return std::nullopt;
  const auto size = file.size();
  if (!size || *size < sizeof(Header) || *size - sizeof(Header) > max_content_bytes) return std::nullopt;
  Header found;
  std::vector<unsigned char> content(*size - sizeof(Header));
  if (!file.read_all(&found, sizeof found) || !file.read_all(content.data(), content.size())) return std::nullopt;
  const Header expected = header_for(key, content);
  if (std::memcmp(&found, &expected, sizeof found) != 0) return std::nullopt;
  return content;
}

bool DiskCache::store(const CacheKey& key, std::span<const unsigned char> content, std::string* trouble) const {
  if (!folder_ || content.size() > max_content_bytes) return false;
  std::error_code failure;
  fs::create_directories(*folder_, failure);
  if (failure) {
    if (trouble != nullptr) *trouble = failure.message();
    return false;
  }
  const std::string name = file_of(key).string();
  remove_stale_temporaries(*folder_ / "");
  TemporaryFile file(name, 0600);
  const Header header = header_for(key, content);
  const auto write = [&](const void* bytes, std::size_t count) {
    return file.write_all({static_cast<const char*>(bytes), count});
  };
  if (file.error() == 0 && write(&header, sizeof header) && write(content.data(), content.size()) && file.publish())
    return true;
  if (trouble != nullptr) *trouble = std::strerror(file.error());
  return false;
}

}  // namespace morphcl
