// A folder of checked blobs, one file a key, shared by any number of processes.
//
// A file appears under its name only when it is whole (temporary name, then rename), and carries its key, length and
// checksum: what was cut, altered or renamed by others is not found, as if it were missing. No operation reports
// failure otherwise: an absent or unwritable folder makes every load a miss and every store do nothing. Layout of a
// file: "morphcl\1", key (16 bytes), length (8), XXH3-64 of the content (8), content; host byte order.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace morphcl {

struct CacheKey {
  std::uint64_t high = 0, low = 0;

  std::string hex() const;  // 32 digits
};

// XXH3-128 of the parts, each with its length, so that no two lists of parts run together.
CacheKey cache_key(std::span<const std::string> parts);

class DiskCache {
 public:
  // Files are folder/KEY.SUFFIX; nullopt: never finds and never stores.
  DiskCache(std::optional<std::filesystem::path> folder, std::string suffix);

  bool has_folder() const { return folder_.has_value(); }

  std::optional<std::vector<unsigned char>> load(const CacheKey& key) const;

  // True if the content stands under its key now. Creates the folder. `trouble` gets the system's reason where the
  // folder does not take it.
  bool store(const CacheKey& key, std::span<const unsigned char> content, std::string* trouble = nullptr) const;

 private:
  std::filesystem::path file_of(const CacheKey& key) const;

  std::optional<std::filesystem::path> folder_;
  std::string suffix_;
};

}  // namespace morphcl
