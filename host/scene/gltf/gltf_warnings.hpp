// What a glTF file holds that is not drawn: collected while it is read, told in one line.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "host/scene/gltf/gltf_document.hpp"

namespace morphcl {

class GltfWarnings {
 public:
  void not_drawn(std::string what) { not_drawn_.insert(std::move(what)); }  // "skins"
  void say(std::string line);  // a line of its own; repeated ones count once

  // The member "name", which only annotates: `otherwise` when it is missing or no text, with a warning.
  std::string read_name(const GltfValue& value, std::string otherwise);

  // Looks for whole features that the importer does not read: skins, textures, unknown extensions.
  void survey(const GltfDocument& document);

  std::vector<std::string> lines() const;  // "skins and textures are not drawn" first

 private:
  std::set<std::string> not_drawn_;
  std::vector<std::string> lines_;
};

}  // namespace morphcl
