// The device renderer with a limit that tests lower.
#pragma once

#include <cstddef>
#include <memory>

#include "morphcl/renderer.hpp"

namespace morphcl {

// A picture is handed to the device as one buffer, or band by band where it has more bytes than the device allocates in
// one piece. `max_band` lowers that limit; a band has a row of tiles (64 pixels) at least.
std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session, std::size_t max_band);

}  // namespace morphcl
