#include "host/scene/gltf/gltf_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// What is wrong with a colour costs the colour, not the model.
std::optional<glm::dvec4> base_color(const GltfValue& material, GltfWarnings& warnings) {
  try {
    const auto surface = material.find("pbrMetallicRoughness");
    const auto factor = surface ? surface->find("baseColorFactor") : std::nullopt;
    if (!factor) return std::nullopt;
    const std::vector<double> given = factor->numbers(4);
    glm::dvec4 color;
    for (int c = 0; c < 4; ++c) {
      const double value = given[static_cast<std::size_t>(c)];
      color[c] = std::clamp(value, 0.0, 1.0);
      if (color[c] != value)
        warnings.say(fmt::format("{}: holds {}; factors are from 0 to 1, so it is clamped", factor->place(), value));
    }
    return color;
  } catch (const Error& error) {
    warnings.say(fmt::format("{}; the default colour is used", error.what()));
    return std::nullopt;
  }
}

// "" where it has none; what is no text costs the name.
std::string name_of_material(const GltfValue& material) {
  try {
    return material.text("name", "");
  } catch (const Error&) {
    return "";
  }
}

bool glows(const GltfValue& material, GltfWarnings& warnings) {
  try {
    const auto factor = material.find("emissiveFactor");
    const std::vector<double> emission = factor ? factor->numbers(3) : std::vector<double>{};
    return std::any_of(emission.begin(), emission.end(), [](double value) { return value != 0; });
  } catch (const Error& error) {
    warnings.say(fmt::format("{}; it is not drawn in any case", error.what()));
    return false;
  }
}

std::string alpha_mode(const GltfValue& material, GltfWarnings& warnings) {
  const std::string mode = material.text("alphaMode", "OPAQUE");
  if (mode == "OPAQUE" || mode == "BLEND" || mode == "MASK") return mode;
  warnings.say(fmt::format("{}: is '{}'; OPAQUE, MASK or BLEND are modes, and OPAQUE is used",
                           material.get("alphaMode").place(), mode));
  return "OPAQUE";
}

GltfMaterial read_material(const GltfValue& json, GltfWarnings& warnings) {
  GltfMaterial result;
  result.material.name = name_of_material(json);
  result.material.base_color = base_color(json, warnings).value_or(glm::dvec4(1.0));
  if (glows(json, warnings)) warnings.not_drawn("emission");
  result.material.double_sided = json.boolean("doubleSided", false);
  const std::string mode = alpha_mode(json, warnings);
  const double alpha = result.material.base_color.a;
  result.has_alpha = mode != "OPAQUE";
  if (mode == "MASK") {
    result.material.alpha_mode = AlphaMode::mask;
    result.material.alpha_cutoff = json.number("alphaCutoff", 0.5);
    // Textures and vertex colours only ever lower alpha.
    result.seen = !(alpha < result.material.alpha_cutoff);
  } else if (mode == "BLEND") {
    result.seen = alpha > 0;
  } else {
    result.material.base_color.a = 1.0;
  }
  if (const auto extensions = json.find("extensions"); extensions && extensions->find("KHR_materials_unlit"))
    result.material.shading = Shading::unlit;
  return result;
}

}  // namespace

GltfMaterial read_material(const GltfDocument& document, int index, GltfWarnings& warnings) {
  GltfMaterial plain;
  plain.material.base_color = glm::dvec4(1.0);
  if (index < 0) return plain;
  try {
    return read_material(document.element("materials", static_cast<std::size_t>(index)), warnings);
  } catch (const Error& error) {
    warnings.say(fmt::format("{}; the default material is used", error.what()));
    return plain;
  }
}

}  // namespace morphcl
