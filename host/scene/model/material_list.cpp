#include "host/scene/model/material_list.hpp"

#include <string_view>
#include <unordered_map>

namespace morphcl {

const std::string& material_name(const Object& object) {
  return object.material.name.empty() ? object.name : object.material.name;
}

MaterialList list_materials(const Scene& scene) {
  MaterialList list;
  std::unordered_map<std::string_view, std::uint32_t> numbers;
  for (const Object& object : scene.objects) {
    const std::string& name = material_name(object);
    const auto [found, is_new] = numbers.try_emplace(name, static_cast<std::uint32_t>(list.names.size()));
    if (is_new) list.names.push_back(name);
    list.of_object.push_back(found->second);
  }
  return list;
}

std::vector<std::string> material_names(const Scene& scene) { return list_materials(scene).names; }

}  // namespace morphcl
