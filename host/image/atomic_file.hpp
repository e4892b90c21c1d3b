// Files that stand under their name whole or not at all.
//
// The bytes go to a temporary file in the same folder (host/temporary_file.hpp), are flushed to the disk and renamed;
// the folder is flushed after that. A process that is killed leaves at most such a temporary file behind.
#pragma once

#include <span>
#include <string>

namespace morphcl {

// Makes missing folders. Error(cannot_create) when a folder or the file cannot be made, or when `path` is there and is
// not a regular file (a device is never replaced); Error(write_failed) when not all bytes reach the disk, with the
// system's reason. After an error nothing is left behind and an older file of that name still stands.
void write_file_atomically(const std::string& path, std::span<const char> bytes);

// Error(cannot_create) when the file system takes no name of this length in the folder of `path`, which exists.
void check_name_length(const std::string& path);

// Makes the folder of `path`, makes a temporary file for it and removes that again: throws what
// write_file_atomically(path, ...) would throw before its first byte.
void check_can_create(const std::string& path);

}  // namespace morphcl
