// A temporary folder that belongs to this process alone and goes with it, however it ends.
#pragma once

#include <filesystem>
#include <string>

namespace morphcl {

// A fresh folder "PREFIX-XXXXXX" below `parent`, for this user only; removed when the process exits. Folders of the
// same prefix that processes of this user left when they were killed are removed as well: a living process holds a lock
// on the file "owner" in its folder. Returns an empty path when no folder can be made. Not for use from several
// threads.
std::filesystem::path make_process_folder(const std::filesystem::path& parent, const std::string& prefix);

}  // namespace morphcl
