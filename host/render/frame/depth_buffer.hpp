// The depth buffer of a frame as renderers get it.
#pragma once

#include <array>

#include "host/math/depth_format.hpp"

namespace morphcl {

// Renderers measure depth as q = near / distance, in parallel projections q = -distance, and the reversed float buffer
// holds just that. The other formats hold the closeness (q - far) * scale, 1 on the near plane and 0 on the far one.
struct DepthBuffer {
  DepthFormat format = DepthFormat::reversed_float;
  std::array<float, 2> far{}, scale{};  // each a number of about 48 bits, the unevaluated sum of two floats
  float span = 0;                       // 1 / scale

  bool is_forward() const { return format != DepthFormat::reversed_float; }
};

// `near` is the near plane of the renderers, `far` may be infinite in perspective. Error(usage) when near and far are
// so close together, or a parallel projection's so far away, that fp32 does not hold these numbers.
DepthBuffer make_depth_buffer(DepthFormat format, float near, double far, bool parallel);

}  // namespace morphcl
