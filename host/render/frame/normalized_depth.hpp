// The reference's view of kernels/forward_depth.h: depth buffers that span near to far.
#pragma once

#include "host/render/frame/depth_buffer.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/two_float.hpp"

namespace morphcl::reference {

// 1 on the near plane, 0 on the far one, negative beyond it.
TwoFloat normalized_depth_of(float distance, const FramePlan& plan);

// What the buffer holds, as an order: larger is nearer. `normalized_depth` of up to 1; what is negative gets the key of
// 0.
std::uint32_t key_of(const TwoFloat& normalized_depth, DepthFormat format);

// near / distance, or minus the distance in parallel projections, of the distance that a key stands for.
float decoded_depth(std::uint32_t key, const FramePlan& plan);

}  // namespace morphcl::reference
