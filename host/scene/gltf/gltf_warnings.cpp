#include "host/scene/gltf/gltf_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// A hostile file may give occasion to any number of warnings.
constexpr std::size_t max_lines = 20, max_features = 20, max_name = 60;

// Read, or only of use with textures, which are named themselves.
constexpr std::array silent_extensions = {"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_lights_punctual",
                                          "KHR_texture_transform", "KHR_texture_basisu",  "EXT_texture_webp"};

}  // namespace

void GltfWarnings::say(std::string line) {
  line = printable(line);
  if (lines_.size() < max_lines && std::find(lines_.begin(), lines_.end(), line) == lines_.end())
    lines_.push_back(std::move(line));
}

std::string GltfWarnings::read_name(const GltfValue& value, std::string otherwise) {
  try {
    return value.text("name", otherwise);
  } catch (const Error& error) {
    say(fmt::format("{}; it is not used", error.what()));
    return otherwise;
  }
}

void GltfWarnings::survey(const GltfDocument& document) {
  if (document.count("skins") > 0) not_drawn("skins");
  if (document.count("textures") > 0) not_drawn("textures");
  for (const char* list : {"extensionsUsed", "extensionsRequired"})
    for (std::size_t i = 0; i < document.count(list); ++i) {
      const GltfValue element = document.element(list, i);
      const std::string& name = element.text();
      if (std::find(silent_extensions.begin(), silent_extensions.end(), name) == silent_extensions.end())
        not_drawn("extension " + printable(name).substr(0, max_name));
    }
}

std::vector<std::string> GltfWarnings::lines() const {
  std::vector<std::string> all;
  if (!not_drawn_.empty()) {
    std::string names;
    std::size_t told = 0;
    for (const std::string& name : not_drawn_) {
      if (told == max_features) break;
      if (told > 0) names += ", ";
      names += name;
      ++told;
    }
    if (told < not_drawn_.size()) names += fmt::format(" and {} more", not_drawn_.size() - told);
    all.push_back("not drawn: " + names);
  }
  all.insert(all.end(), lines_.begin(), lines_.end());
  return all;
}

}  // namespace morphcl
