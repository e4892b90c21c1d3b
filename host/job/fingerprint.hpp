// The fingerprint of a job: by it a resumed job knows its own frames.
#pragma once

#include <string>

#include "host/scene/model/scene.hpp"

namespace morphcl {

// 32 hex digits over everything that decides a frame's file but its number: every byte that was read for the scene, the
// image's size, channels and compression, the frame rate and morphcl's version. Frame range, names and device are not
// in it.
std::string fingerprint(const Scene& scene);

}  // namespace morphcl
