// One animation sampler of a glTF file as a Track.
#pragma once

#include "host/scene/gltf/gltf_accessor.hpp"
#include "host/scene/gltf/gltf_warnings.hpp"
#include "morphcl/track.hpp"

namespace morphcl {

struct GltfSamplerUse {
  std::size_t width;  // components a key: 3, 4, or the number of morph targets
  bool rotation;      // VEC4, float or normalized
  bool weights;       // SCALAR, float or normalized; else VEC3 float
};

struct GltfSampler {
  Track track;
  double last_seconds = 0;  // time of the last key
  std::uint64_t bytes = 0;  // that a copy of the track takes
};

// Errors: see gltf_animation.hpp.
GltfSampler read_sampler(const GltfValue& json, const GltfDocument& document, const GltfAccessors& accessors,
                         const TimeBase& time, const GltfSamplerUse& use, GltfWarnings& warnings);

}  // namespace morphcl
