// Camera and lights of a glTF file: KHR_lights_punctual's directional and point lights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/scene/gltf/gltf_nodes.hpp"

namespace morphcl {

struct GltfCamera {
  Camera camera;
  std::optional<double> aspect;  // width / height that a perspective was made for
};

// The camera that `wanted` names, by its own name, that of a node that holds it, or its index; without it that of the
// first drawn node that has one, with a warning when there are more. An orthographic window is widened to fit the
// image. All cameras are listed in `parts`. Error(bad_input) for a degenerate projection; Error(usage): there is none
// of that name, or no node holds it.
std::optional<GltfCamera> read_camera(const GltfDocument& document, const GltfNodes& nodes,
                                      const std::optional<std::string>& wanted, std::vector<ModelPart>& parts,
                                      GltfWarnings& warnings);

// The lights of the drawn nodes, where their nodes stand at rest. The specification's intensities are photometric and
// its diffuse reflection is base colour / pi, so the colour here is colour * intensity / pi. Spot lights and the range
// of point lights are named in a warning.
std::vector<Light> read_lights(const GltfDocument& document, const GltfNodes& nodes, GltfWarnings& warnings);

}  // namespace morphcl
