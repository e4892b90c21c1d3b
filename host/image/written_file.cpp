#include "host/image/written_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "morphcl/error.hpp"

namespace morphcl {

void require_read_back(const std::string& path, const std::string& hash, const std::string& found) {
  if (found == hash) return;
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  throw Error(ErrorKind::write_failed, path,
              fmt::format("was written with the pixel hash {} and reads back with: {}; check the disk", hash, found));
}

}  // namespace morphcl
