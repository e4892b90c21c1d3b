#include "tests/architecture/include_arrows.hpp"

#include <algorithm>
#include <fstream>

namespace morphcl::architecture {

namespace fs = std::filesystem;

namespace {
struct Include {
  std::string from;  // path from the root
  int line;
  std::string to;
  bool angled;
};

const std::vector<std::string> library_folders = {"host", "anim", "kernels"};
const std::vector<std::string> outer_folders = {"cli", "demos", "tests", "bench"};

bool is_source(const fs::path& path) {
  static const std::set<std::string> extensions = {".hpp", ".cpp", ".h", ".cl", ".in"};
  return extensions.count(path.extension().string()) != 0;
}

bool starts_with_folder(const std::string& path, const std::string& folder) {
  return path.compare(0, folder.size() + 1, folder + "/") == 0;
}

// "host/math" for host/math/a.hpp, "host" for host/error.hpp, "anim" for anim/deep/b.hpp, "tests" for tests/x/y.cpp.
std::string folder_of(const std::string& path) {
  const std::size_t first = path.find('/');
  if (first == std::string::npos) return "";
  if (path.compare(0, first, "host") != 0) return path.substr(0, first);
  const std::size_t second = path.find('/', first + 1);
  return path.substr(0, second == std::string::npos ? first : second);
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
  std::vector<std::string> folders = library_folders;
  folders.insert(folders.end(), outer_folders.begin(), outer_folders.end());
  for (const std::string& folder : folders) {
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

// Kernels name their headers without a folder.
std::string from_root(const Include& include) {
  return starts_with_folder(include.from, "kernels") && include.to.find('/') == std::string::npos
             ? "kernels/" + include.to
             : include.to;
}

std::string why_forbidden(const Include& include, const Arrows& arrows) {
  const std::string from = folder_of(include.from), to = folder_of(from_root(include));
  // The header that users include to have everything stands above all folders.
  const std::string umbrella = "host/morphcl.hpp";
  if (include.from == umbrella && !is_outer(to)) return "";
  if (from_root(include) == umbrella && !is_outer(from)) return "the library does not include its own umbrella header";
  if (from == to || to == "host") return "";
  if (is_outer(to)) return starts_with_folder(include.from, "tests/" + to) ? "" : "only its own tests include " + to;
  if (is_outer(from)) return "";
  const auto entry = arrows.find(from);
  if (entry == arrows.end()) return from + " is no folder of the layout";
  if (entry->second.count(to) != 0) return "";
  std::string list;
  for (const std::string& folder : entry->second) list += (list.empty() ? "" : ", ") + folder;
  return from + " may include: " + (list.empty() ? "nothing" : list);
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

const Arrows& allowed_arrows() {
  static const Arrows arrows = {
      {"kernels", {}},
      {"host", {}},
      {"host/math", {}},
      {"anim", {"host/math"}},
      {"host/geometry", {"host/math"}},
      {"host/visibility", {}},
      {"host/image", {"host/math"}},
      {"host/scene", {"anim", "host/geometry", "host/math"}},
      {"host/device", {"kernels"}},
      {"host/batch", {"host/device", "host/math", "kernels"}},
      {"host/render", {"host/device", "host/scene", "host/geometry", "host/math", "host/image", "anim", "kernels"}},
      {"host/job", {"host/render", "host/scene", "host/image", "anim"}},
      {"host/accuracy",
       {"host/render", "host/batch", "host/device", "host/scene", "host/geometry", "host/image", "host/math", "anim"}},
  };
  return arrows;
}

std::vector<std::string> forbidden_includes(const fs::path& root, const Arrows& arrows,
                                            const std::set<std::string>& generated) {
  std::vector<std::string> lines;
  for (const Include& include : all_includes(root)) {
    if (include.angled) continue;
    const std::string place = include.from + ":" + std::to_string(include.line) + " includes " + include.to + "; ";
    if (!fs::exists(root / from_root(include)) && generated.count(include.to) == 0)
      lines.push_back(place + "there is no such file from the root");
    else if (const std::string why = why_forbidden(include, arrows); !why.empty())
      lines.push_back(place + why);
  }
  return lines;
}

std::vector<std::string> include_circles(const fs::path& root) {
  std::map<std::string, std::vector<std::string>> graph;
  for (const Include& include : all_includes(root))
    if (!include.angled) graph[include.from].push_back(from_root(include));
  return CircleSearch(std::move(graph)).run();
}

std::vector<std::string> forbidden_packages(const fs::path& root,
                                            const std::map<std::string, std::set<std::string>>& homes) {
  std::vector<std::string> lines;
  for (const Include& include : all_includes(root)) {
    if (!include.angled) continue;
    for (const auto& [package, folders] : homes) {
      if (include.to.compare(0, package.size(), package) != 0) continue;
      const auto covers = [&](const std::string& folder) { return starts_with_folder(include.from, folder); };
      if (std::none_of(folders.begin(), folders.end(), covers))
        lines.push_back(include.from + ":" + std::to_string(include.line) + " includes <" + include.to + ">");
    }
  }
  return lines;
}

}  // namespace morphcl::architecture
