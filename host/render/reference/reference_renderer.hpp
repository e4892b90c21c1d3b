// Renders frame plans with plain loops: slow, short, and the meaning of what the kernels compute.
#pragma once

#include <memory>

#include "host/render/frame/renderer.hpp"

namespace morphcl {

std::unique_ptr<Renderer> make_reference_renderer();

}  // namespace morphcl
