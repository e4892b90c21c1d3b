// The fingerprint of a job: by it a resumed job knows its own frames.
#pragma once

#include <string>

#include "morphcl/scene.hpp"

namespace morphcl {

// 32 hex digits over everything that decides a frame's file but its number: the image's settings, meshes, objects,
// nodes, tracks, camera and lights, every byte that was read for the scene, and morphcl's version. Frame range, names,
// warnings and device are not in it.
std::string fingerprint(const Scene& scene);

}  // namespace morphcl
