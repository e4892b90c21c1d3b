// Renders frame plans with OpenCL kernels.
#pragma once

#include <memory>

#include "host/device/session.hpp"
#include "host/render/frame/renderer.hpp"

namespace morphcl {

std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session);

}  // namespace morphcl
