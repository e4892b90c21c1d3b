#include "host/scene/gltf/gltf_material.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphcl {

namespace {

double unit_factor(double value, const GltfValue& json) {
  if (!(value >= 0 && value <= 1)) json.fail(fmt::format("holds {}; factors are from 0 to 1", value));
  return value;
}

}  // namespace

GltfMaterial read_material(const GltfDocument& document, int index, GltfWarnings& warnings) {
  GltfMaterial result;
  result.material.base_color = glm::dvec4(1.0);
  if (index < 0) return result;
  const GltfValue json = document.element("materials", static_cast<std::size_t>(index));
  if (const auto surface = json.find("pbrMetallicRoughness"))
    if (const auto factor = surface->find("baseColorFactor")) {
      const std::vector<double> color = factor->numbers(4);
      for (int c = 0; c < 4; ++c)
        result.material.base_color[c] = unit_factor(color[static_cast<std::size_t>(c)], *factor);
    }
  if (const auto factor = json.find("emissiveFactor")) {
    const std::vector<double> emission = factor->numbers(3);
    if (std::any_of(emission.begin(), emission.end(), [](double value) { return value != 0; }))
      warnings.not_drawn("emission");
  }
  result.material.double_sided = json.boolean("doubleSided", false);
  const std::string mode = json.text("alphaMode", "OPAQUE");
  if (mode == "MASK")
    warnings.not_drawn("alpha masks");
  else if (mode != "OPAQUE" && mode != "BLEND")
    json.get("alphaMode").fail(fmt::format("is '{}'; OPAQUE, MASK or BLEND are modes", mode));
  result.blend = mode == "BLEND";
  if (!result.blend) result.material.base_color.a = 1.0;
  if (const auto extensions = json.find("extensions"); extensions && extensions->find("KHR_materials_unlit"))
    result.material.shading = Shading::unlit;
  return result;
}

}  // namespace morphcl
