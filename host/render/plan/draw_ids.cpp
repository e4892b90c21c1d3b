#include "host/render/plan/draw_ids.hpp"

#include "host/cryptomatte_id.hpp"
#include "host/cryptomatte_manifest.hpp"
#include "host/scene/model/material_list.hpp"

namespace morphcl {

DrawIds::DrawIds(const Scene& scene) {
  const ChannelSet asked_for = scene.image.channels;
  constexpr ChannelSet with_ids{Channel::object_id, Channel::material_id, Channel::crypto_object,
                                Channel::crypto_material};
  if ((asked_for & with_ids).empty()) return;
  const MaterialList materials = list_materials(scene);
  of_object_.resize(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Ids& ids = of_object_[i];
    const std::uint32_t material = materials.of_object[i];
    if (asked_for.contains(Channel::object_id)) ids.object = static_cast<std::uint32_t>(i + 1);
    if (asked_for.contains(Channel::material_id)) ids.material = material + 1;
    if (asked_for.contains(Channel::crypto_object)) ids.crypto_object = cryptomatte_id(scene.objects[i].name);
    if (asked_for.contains(Channel::crypto_material)) ids.crypto_material = cryptomatte_id(materials.names[material]);
  }
}

void DrawIds::set(std::size_t object, Draw& draw) const {
  const Ids ids = of_object_.empty() ? Ids() : of_object_[object];
  draw.object_id = ids.object;
  draw.material_id = ids.material;
  draw.crypto_object = ids.crypto_object;
  draw.crypto_material = ids.crypto_material;
}

std::shared_ptr<const CryptomatteManifests> cryptomatte_manifests(const Scene& scene) {
  const ChannelSet asked_for = scene.image.channels & cryptomatte_channels;
  if (asked_for.empty()) return nullptr;
  auto manifests = std::make_shared<CryptomatteManifests>();
  if (asked_for.contains(Channel::crypto_object)) {
    std::vector<std::string> names;
    for (const Object& object : scene.objects) names.push_back(object.name);
    manifests->objects = cryptomatte_manifest(names);
  }
  if (asked_for.contains(Channel::crypto_material)) manifests->materials = cryptomatte_manifest(material_names(scene));
  return manifests;
}

}  // namespace morphcl
