// Camera and lights of a glTF file: KHR_lights_punctual's directional and point lights.
#pragma once

#include <optional>
#include <vector>

#include "host/scene/gltf/gltf_nodes.hpp"

namespace morphcl {

// The camera of the first drawn node that has one; a warning when there are more. Its aspectRatio is not used: the
// image has its own. Error(bad_input) for a degenerate projection.
std::optional<Camera> read_camera(const GltfDocument& document, const GltfNodes& nodes, GltfWarnings& warnings);

// The lights of the drawn nodes, where their nodes stand at rest. The specification's intensities are photometric and
// its diffuse reflection is base colour / pi, so the colour here is colour * intensity / pi. Spot lights and the range
// of point lights are named in a warning.
std::vector<Light> read_lights(const GltfDocument& document, const GltfNodes& nodes, GltfWarnings& warnings);

}  // namespace morphcl
