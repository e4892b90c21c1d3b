// Reading the files of a model or shot: bounded, and confined to the folder of the file that names them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace morphcl {

// All bytes of a regular file. Error(cannot_read) with the system's reason when it is missing, a folder, not a regular
// file or unreadable; Error(bad_input) when it holds more than `max_bytes` (checked before anything is read).
std::string read_input_file(const std::string& path, std::uint64_t max_bytes);

// Error(bad_input) at `file` for text in UTF-16 or UTF-32, which its first bytes tell: what is read is UTF-8.
void require_utf8(std::string_view text, const std::string& file);

// The path of `reference`, a relative path with '/' written in the file `owner`, seen from owner's folder. Unless
// `allow_outside`, Error(bad_input) at `place` when it is absolute, has a scheme or a drive, or leads out of that
// folder, after every ".." and symbolic link is resolved.
std::string confined_path(const std::string& owner, std::string_view reference, bool allow_outside,
                          std::string_view place);

}  // namespace morphcl
