// The numbers by which channels name a draw's object and its material.
#pragma once

#include <memory>
#include <vector>

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

class DrawIds {
 public:
  // What the scene's channels ask for: object_id, material_id, crypto_object, crypto_material. For as long as neither
  // they nor the names change.
  explicit DrawIds(const Scene& scene);

  // Sets the ids of a draw of the scene's object; those that are not asked for become 0.
  void set(std::size_t object, Draw& draw) const;

 private:
  struct Ids {
    std::uint32_t object = 0, material = 0;
    float crypto_object = 0, crypto_material = 0;
  };
  std::vector<Ids> of_object_;  // empty: nothing is asked for
};

// Of the Cryptomatte channels that the scene asks for; null where it asks for none.
std::shared_ptr<const CryptomatteManifests> cryptomatte_manifests(const Scene& scene);

}  // namespace morphcl
