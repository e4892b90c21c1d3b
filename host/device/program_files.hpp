// What PoCL leaves in its cache folder for a program that was built from source and has run: a folder named after what
// it was made of, with the compiled kernels in it. Taken out and put back as it is, it spares a later process the
// compiler, and is there at once, where asking PoCL for the program's binary has it compile every kernel once more.
//
// The layout is PoCL's own affair, but for this: the folder is two levels down, and holds a folder of each kernel's
// name with a shared object somewhere in it. Where that is not so, nothing is taken out.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace morphcl {

// Of all programs in PoCL's folder, relative to it.
std::set<std::filesystem::path> program_folders(const std::filesystem::path& pocl_folder);

// All files of a program's folder, which is relative to PoCL's. Nothing unless each of `kernels` (at least one) has a
// shared object there.
std::optional<std::vector<unsigned char>> pack_program_files(const std::filesystem::path& pocl_folder,
                                                             const std::filesystem::path& program,
                                                             const std::set<std::string>& kernels);

// Puts them back, all or none of them. Returns the program's folder; nothing where it cannot be written, and for bytes
// that pack_program_files() did not make. What stands there already stays.
std::optional<std::filesystem::path> unpack_program_files(const std::filesystem::path& pocl_folder,
                                                          std::span<const unsigned char> packed);

}  // namespace morphcl
