// The depth buffer of a frame as renderers get it.
#pragma once

#include "host/render/frame/camera_constants.hpp"
#include "morphcl/depth_format.hpp"

namespace morphcl {

// Renderers measure depth as q = near / distance, in parallel projections q = -distance, and the reversed float buffer
// holds just that. The other formats hold the normalized depth (q - depth_far) * depth_scale, 1 on the near plane and 0
// on the far one; depth_far and depth_scale are numbers of about 48 bits, the unevaluated sums of two floats.
constexpr bool is_forward(DepthFormat format) { return format != DepthFormat::reversed_float; }

// Sets depth_far, depth_scale and depth_span of a camera whose other numbers are set; 0 for reversed_float. `far` is
// the distance of the far plane, which may be infinite in perspective. Error(usage) when near and far are so close
// together, or a parallel projection's so far away, that fp32 does not hold these numbers.
void set_depth_buffer(DepthFormat format, double far, CameraConstants& camera);

}  // namespace morphcl
