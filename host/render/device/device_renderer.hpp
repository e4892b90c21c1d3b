// The device renderer with what its users within the library set: a limit, and a say in which kernels it starts.
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "morphcl/depth_format.hpp"
#include "morphcl/renderer.hpp"

namespace morphcl {

// A picture is handed to the device as one buffer, or band by band where it has more bytes than the device allocates in
// one piece. `max_band` lowers that limit; a band has a row of tiles (64 pixels) at least.
std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session, std::size_t max_band);

// A kernel of a frame: kernels/STAGE.cl, its name there, and the options that it is compiled with (kernel_of).
struct FrameKernel {
  std::string stage, name, options;
  auto operator<=>(const FrameKernel&) const = default;
};

// `before_first` is called before a kernel is started for the first time by this renderer, which may have it compiled,
// a matter of seconds. What it throws render() throws; the frame is not drawn then, and the next one is like any other.
using BeforeFirstUse = std::function<void(const FrameKernel&)>;
std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session, BeforeFirstUse before_first);

// The options of kernels for a depth buffer and so many samples a pixel. `blends`: some draw is blended; of kernels
// that shade, the others do not know the difference.
std::string kernel_options(DepthFormat format, int samples, bool blends = false);

}  // namespace morphcl
