// Which folder may include which: reads every #include "..." below a source tree and finds the arrows that the layout
// does not allow, and circles among the files.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace morphcl::architecture {

// A folder of the library -> the folders that its files may include besides itself and the files directly in host/.
using Arrows = std::map<std::string, std::set<std::string>>;

// The layout's arrows. cli, demos, tests and bench may include everything but one another; tests/cli may include cli,
// and so on.
const Arrows& allowed_arrows();

// One line a forbidden arrow: "host/math/a.hpp:3 includes host/render/plan.hpp; host/math may include: ...". Also an
// include of a file that does not exist, unless the build makes it (`generated`, paths from the root).
std::vector<std::string> forbidden_includes(const std::filesystem::path& root, const Arrows& arrows,
                                            const std::set<std::string>& generated);

// One line a circle of files that include each other: "a.hpp -> b.hpp -> a.hpp".
std::vector<std::string> include_circles(const std::filesystem::path& root);

// Packages: a header in angle brackets that starts with a key may be included only below the folders of its value.
std::vector<std::string> forbidden_packages(const std::filesystem::path& root,
                                            const std::map<std::string, std::set<std::string>>& homes);

}  // namespace morphcl::architecture
