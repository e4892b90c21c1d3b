#include "tests/scene/shot_folder.hpp"

#include "morphcl/error.hpp"

namespace morphcl::test {

Scene ShotFolder::load(std::string_view shot, const LoadOptions& options) const {
  write("shot.toml", shot);
  return load_scene(path("shot.toml"), options);
}

std::string ShotFolder::refusal(std::string_view shot, const LoadOptions& options) const {
  try {
    load(shot, options);
  } catch (const Error& error) {
    std::string line = error.what();
    const std::string prefix = folder_.path().string() + "/";
    for (std::size_t at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
      line.erase(at, prefix.size());
    if (error.kind() == ErrorKind::cannot_read) return "cannot read: " + line;
    return (error.kind() == ErrorKind::bad_input ? "" : "NOT bad_input: ") + line;
  }
  return "";
}

}  // namespace morphcl::test
