// The reference's view of the second half of kernels/shade_samples.cl: a pixel of several samples, put together.
#pragma once

#include <array>

#include "host/render/reference/shade.hpp"

namespace morphcl::reference {

// The halves of R, G, B, A. `visible` has any number of samples a pixel.
//
// What blended draws show of a sample is summed up from front to back. The background comes first, then what is opaque
// in the samples, in the order of their first sample, each shaded once: sums of colour times what is let through, by
// fma; then what is blended in front of each sample; all over the number of samples.
std::array<std::uint16_t, 4> resolve_pixel(const FramePlan& plan, const Visibility& visible,
                                           const std::vector<std::vector<Vertex>>& vertices, int x, int y);

// What a layer shows. It is shaded once a pixel: at the centre, or the mean of all samples that it covers.
ShadedSurface shade_layer(const FramePlan& plan, const Visibility& visible, const Sample& layer,
                          const std::vector<std::vector<Vertex>>& vertices, int x, int y);

// What a pixel's distance is of, where `visible` has one sample a pixel: the nearest surface whose alpha is at least
// one half. Its order is no_order where there is none.
const Sample& surface_at_centre(const FramePlan& plan, const Visibility& visible,
                                const std::vector<std::vector<Vertex>>& vertices, int x, int y);

// Of each sample what surface_at_centre() is of the centre, and what coverage is where some draw is blended: the mean
// of 1 where something is opaque, elsewhere of what the layers do not let through.
struct ShownSurfaces {
  std::vector<Sample> of_samples;
  float coverage;
};
ShownSurfaces shown_surfaces(const FramePlan& plan, const Visibility& visible,
                             const std::vector<std::vector<Vertex>>& vertices, int x, int y);

}  // namespace morphcl::reference
