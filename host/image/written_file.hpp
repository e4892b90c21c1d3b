// Files that were just written, read back.
#pragma once

#include <string>

namespace morphcl {

// For a file that was written with the pixel hash `hash` and reads back with `found`, which may be the reason why it
// does not read: where they differ the file is removed, and Error(write_failed) thrown.
void require_read_back(const std::string& path, const std::string& hash, const std::string& found);

}  // namespace morphcl
