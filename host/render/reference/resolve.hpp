// The reference's view of the second half of kernels/shade_samples.cl: a pixel of several samples, put together.
#pragma once

#include <array>

#include "host/render/reference/shade.hpp"

namespace morphcl::reference {

// The halves of R, G, B, A. The background comes first, then what the samples show, in the order of their first sample,
// each shaded once: sums of colour times number of samples, by fma, over the number of all. `visible` has plan.samples.
std::array<std::uint16_t, 4> resolve_pixel(const FramePlan& plan, const Visibility& visible,
                                           const std::vector<std::vector<Vertex>>& vertices, int x, int y);

}  // namespace morphcl::reference
