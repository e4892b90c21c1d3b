// Renders frame plans with OpenCL kernels.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>

#include "host/device/session.hpp"
#include "host/render/frame/renderer.hpp"

namespace morphcl {

// A picture is handed to the device as one buffer, or band by band where it has more bytes than the device allocates in
// one piece. `max_band` lowers that limit; a band has a row of tiles (64 pixels) at least.
std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session,
                                               std::size_t max_band = std::numeric_limits<std::size_t>::max());

}  // namespace morphcl
