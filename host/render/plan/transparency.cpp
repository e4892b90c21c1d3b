#include "host/render/plan/transparency.hpp"

#include <algorithm>

namespace morphcl {

namespace {

constexpr ChannelSet channels_of_shares{Channel::color, Channel::coverage, Channel::crypto_object,
                                        Channel::crypto_material};

}  // namespace

bool has_alpha(const Mesh& mesh) {
  const auto differs_from = [](float alpha) { return [alpha](const glm::vec4& color) { return color.a != alpha; }; };
  if (std::ranges::any_of(mesh.colors, differs_from(1))) return true;
  return !mesh.colors.empty() && std::ranges::any_of(mesh.targets, [&](const MorphTarget& target) {
    return std::ranges::any_of(target.colors, differs_from(target.form == TargetForm::absolute ? 1.0f : 0.0f));
  });
}

std::vector<bool> meshes_with_alpha(const Scene& scene) {
  std::vector<bool> result;
  for (const Mesh& mesh : scene.meshes) result.push_back(has_alpha(mesh));
  return result;
}

Transparency transparency_of(const Material& material, double alpha, bool vertex_alpha, ChannelSet channels) {
  if (material.alpha_mode == AlphaMode::opaque) return Transparency::none;
  const bool masked = material.alpha_mode == AlphaMode::mask;
  if (vertex_alpha && material.shading != Shading::wireframe)  // its lines have the base colour alone
    return alpha == 0 && !masked ? Transparency::whole : Transparency::some;
  if (masked) return alpha >= material.alpha_cutoff ? Transparency::none : Transparency::whole;
  if ((channels & channels_of_shares).empty()) return alpha >= 0.5 ? Transparency::none : Transparency::whole;
  return alpha == 1 ? Transparency::none : alpha == 0 ? Transparency::whole : Transparency::some;
}

}  // namespace morphcl
