#include "tests/architecture/include_arrows.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace morphcl::architecture {

namespace fs = std::filesystem;

namespace {
struct Include {
  std::string from;  // path from the root
  int line;
  std::string to;
  bool angled;
};

const std::string public_folder = "include/morphcl";
// What users of the library write, in effect: they may include every room, but not one another.
const std::vector<std::string> outer_folders = {"cli", "demos", "tests", "bench"};
const std::vector<std::string> all_folders = {"include", "host",  "anim",  "kernels", "lab",
                                              "cli",     "demos", "tests", "bench"};

bool is_source(const fs::path& path) {
  static const std::set<std::string> extensions = {".hpp", ".cpp", ".h", ".cl", ".in"};
  return extensions.count(path.extension().string()) != 0;
}

bool starts_with_folder(const std::string& path, const std::string& folder) {
  return path.compare(0, folder.size() + 1, folder + "/") == 0;
}

// The nearest room above a file, or the top folder of one that lies in none.
std::string room_of(const std::string& path, const Rooms& rooms) {
  if (starts_with_folder(path, public_folder)) {
    const std::string stem = fs::path(path).stem().string();
    for (const auto& [name, room] : rooms)
      if (room.public_headers.count(stem) != 0) return name;
    return public_folder;
  }
  for (fs::path folder = fs::path(path).parent_path(); !folder.empty(); folder = folder.parent_path())
    if (rooms.count(folder.generic_string()) != 0) return folder.generic_string();
  return path.substr(0, path.find('/'));
}

void read_includes(const fs::path& root, const fs::path& file, std::vector<Include>& found) {
  std::ifstream stream(file);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("\"<", word + 7);
    if (open == std::string::npos) continue;
    const std::size_t close = line.find_first_of("\">", open + 1);
    if (close == std::string::npos) continue;
    found.push_back({file.lexically_relative(root).generic_string(), number, line.substr(open + 1, close - open - 1),
                     line[open] == '<'});
  }
}

std::vector<Include> all_includes(const fs::path& root) {
  std::vector<Include> found;
  for (const std::string& folder : all_folders) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file() && is_source(entry.path())) read_includes(root, entry.path(), found);
  }
  std::sort(found.begin(), found.end(),
            [](const Include& a, const Include& b) { return std::tie(a.from, a.line) < std::tie(b.from, b.line); });
  return found;
}

bool is_outer(const std::string& folder) {
  return std::find(outer_folders.begin(), outer_folders.end(), folder) != outer_folders.end();
}

// Kernels name their headers without a folder, or by the folder of kernels; public headers by <morphcl/NAME.hpp>.
std::string from_root(const Include& include, const fs::path& root) {
  if (starts_with_folder(include.to, "morphcl")) return "include/" + include.to;
  const fs::path beside = fs::path(include.from).parent_path() / include.to;
  const std::string extension = fs::path(include.from).extension().string();
  const bool in_kernel = extension == ".cl" || extension == ".h";
  if (in_kernel && include.to.find('/') == std::string::npos)
    return fs::exists(root / beside) ? beside.generic_string() : "kernels/" + include.to;
  return include.to;
}

std::string joined(const std::set<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "nothing" : list;
}

std::string why_forbidden(const Include& include, const std::string& target, const Rooms& rooms) {
  const std::string from = room_of(include.from, rooms), to = room_of(target, rooms);
  const bool from_public = starts_with_folder(include.from, public_folder);
  const bool to_public = starts_with_folder(target, public_folder);
  if (from_public && !to_public) return "a public header includes public headers only";
  // The header that users include to have everything stands above all rooms.
  const std::string umbrella = public_folder + "/morphcl.hpp";
  if (include.from == umbrella) return "";
  if (target == umbrella && !is_outer(from)) return "the library does not include its own umbrella header";
  if (from == to) return from == public_folder ? "cmake/rooms.txt does not say whose header this is" : "";
  // Fuzz targets feed the parsers of options too.
  if (is_outer(to))
    return starts_with_folder(include.from, "tests/" + to) || starts_with_folder(include.from, "tests/fuzz")
               ? ""
               : "only its own tests include " + to;
  if (is_outer(from)) return "";
  const auto entry = rooms.find(from);
  if (entry == rooms.end()) return from + " is no room of cmake/rooms.txt";
  if (entry->second.may_include.count(to) != 0) return "";
  return from + " may include: " + joined(entry->second.may_include);
}

// Depth-first search with the path from the root of the search, so that a circle can be printed.
class CircleSearch {
 public:
  explicit CircleSearch(std::map<std::string, std::vector<std::string>> graph) : graph_(std::move(graph)) {}

  std::vector<std::string> run() {
    for (const auto& node : graph_) visit(node.first);
    return circles_;
  }

 private:
  void visit(const std::string& file) {
    if (finished_.count(file) != 0) return;
    const auto at = std::find(path_.begin(), path_.end(), file);
    if (at != path_.end()) {
      std::string circle;
      for (auto step = at; step != path_.end(); ++step) circle += *step + " -> ";
      circles_.push_back(circle + file);
      return;
    }
    path_.push_back(file);
    const auto edges = graph_.find(file);
    if (edges != graph_.end())
      for (const std::string& next : edges->second) visit(next);
    path_.pop_back();
    finished_.insert(file);
  }

  std::map<std::string, std::vector<std::string>> graph_;
  std::set<std::string> finished_;
  std::vector<std::string> path_, circles_;
};
}  // namespace

Rooms read_rooms(const fs::path& root) {
  Rooms rooms;
  std::ifstream stream(root / "cmake/rooms.txt");
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const auto wrong = [&](const std::string& what) {
      return std::runtime_error("cmake/rooms.txt:" + std::to_string(number) + ": " + what);
    };
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) throw wrong("no colon behind the room");
    const auto [entry, added] = rooms.try_emplace(line.substr(0, colon));
    if (!added) throw wrong("a room that stands twice");
    std::istringstream words(line.substr(colon + 1));
    bool headers = false;
    for (std::string word; words >> word;) {
      if (word == "|")
        headers = true;
      else
        (headers ? entry->second.public_headers : entry->second.may_include).insert(word);
    }
  }
  for (const auto& [name, room] : rooms)
    for (const std::string& included : room.may_include)
      if (rooms.count(included) == 0)
        throw std::runtime_error("cmake/rooms.txt: " + name + " names no room " + included);
  return rooms;
}

std::vector<std::string> forbidden_includes(const fs::path& root, const Rooms& rooms,
                                            const std::set<std::string>& generated) {
  std::vector<std::string> lines;
  for (const Include& include : all_includes(root)) {
    const std::string target = from_root(include, root);
    if (include.angled && !starts_with_folder(target, public_folder)) continue;
    const std::string place = include.from + ":" + std::to_string(include.line) + " includes " + include.to + "; ";
    if (!fs::exists(root / target) && generated.count(target) == 0)
      lines.push_back(place + "there is no such file from the root");
    else if (const std::string why = why_forbidden(include, target, rooms); !why.empty())
      lines.push_back(place + why);
  }
  return lines;
}

std::vector<std::string> rooms_in_circles(const Rooms& rooms) {
  // Rooms are removed once everything that they may include is gone; those in a circle never are.
  Rooms left = rooms;
  for (bool removed = true; removed;) {
    removed = std::erase_if(left, [&](const auto& entry) {
                const auto& to = entry.second.may_include;
                return std::none_of(to.begin(), to.end(), [&](const auto& name) { return left.count(name) != 0; });
              }) != 0;
  }
  std::vector<std::string> names;
  for (const auto& entry : left) names.push_back(entry.first);
  return names;
}

std::vector<std::string> include_circles(const fs::path& root) {
  std::map<std::string, std::vector<std::string>> graph;
  for (const Include& include : all_includes(root))
    if (!include.angled || starts_with_folder(include.to, "morphcl"))
      graph[include.from].push_back(from_root(include, root));
  return CircleSearch(std::move(graph)).run();
}

std::vector<std::string> forbidden_packages(const fs::path& root,
                                            const std::map<std::string, std::set<std::string>>& homes) {
  std::vector<std::string> lines;
  for (const Include& include : all_includes(root)) {
    if (!include.angled) continue;
    for (const auto& [package, folders] : homes) {
      if (include.to.compare(0, package.size(), package) != 0) continue;
      const auto covers = [&](const std::string& home) {
        return include.from == home || starts_with_folder(include.from, home);
      };
      if (std::none_of(folders.begin(), folders.end(), covers))
        lines.push_back(include.from + ":" + std::to_string(include.line) + " includes <" + include.to + ">");
    }
  }
  return lines;
}

}  // namespace morphcl::architecture
