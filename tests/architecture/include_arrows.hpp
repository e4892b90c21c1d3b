// Which room may include which: reads every #include "..." below a source tree and finds the arrows that
// cmake/rooms.txt does not allow, and circles among the files.
//
// A room is a folder of cmake/rooms.txt. A file belongs to the nearest room above it: host/render/plan/a.hpp to
// host/render/plan, host/scene/a.cpp to host/scene. A header of include/morphcl belongs to the room that the list says,
// and includes public headers only.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace morphcl::architecture {

struct Room {
  std::set<std::string> may_include;     // besides itself
  std::set<std::string> public_headers;  // stems below include/morphcl
};
using Rooms = std::map<std::string, Room>;

// The list in cmake/rooms.txt below the root. Throws std::runtime_error, naming the line, when a room stands twice or
// another that does not exist is named.
Rooms read_rooms(const std::filesystem::path& root);

// One line a forbidden arrow: "host/math/a.hpp:3 includes host/job/b.hpp; host/math may include: host". Also a file of
// the library in no room, and an include of a file that does not exist, unless the build makes it (`generated`, paths
// from the root).
std::vector<std::string> forbidden_includes(const std::filesystem::path& root, const Rooms& rooms,
                                            const std::set<std::string>& generated);

// One line a circle of files that include each other: "a.hpp -> b.hpp -> a.hpp".
std::vector<std::string> include_circles(const std::filesystem::path& root);

// Rooms from which arrows lead back to themselves.
std::vector<std::string> rooms_in_circles(const Rooms& rooms);

// Packages: a header in angle brackets that starts with a key may be included only below the folders of its value.
std::vector<std::string> forbidden_packages(const std::filesystem::path& root,
                                            const std::map<std::string, std::set<std::string>>& homes);

}  // namespace morphcl::architecture
