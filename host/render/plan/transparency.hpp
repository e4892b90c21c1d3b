// Whether an object lets through what lies behind it.
#pragma once

#include <vector>

#include "morphcl/scene.hpp"

namespace morphcl {

enum class Transparency {
  none,   // alpha is 1 everywhere, or counts as 1
  some,   // it is found at each sample
  whole,  // nothing of it shows
};

// Some vertex or target has an alpha that is not that of an opaque mesh.
bool has_alpha(const Mesh& mesh);
std::vector<bool> meshes_with_alpha(const Scene& scene);  // the same of each

// `alpha`: of the material's base colour at the time. `vertex_alpha`: of its mesh, see meshes_with_alpha(). Where no
// channel shows shares of surfaces, all are of what has an alpha of one half and more: an object of one alpha is there
// or not.
Transparency transparency_of(const Material& material, double alpha, bool vertex_alpha, ChannelSet channels);

}  // namespace morphcl
