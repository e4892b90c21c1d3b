// The tables that the kernels walk through for one plan: draws, active targets, lights, and which draw each vertex
// group and primitive block belongs to.
#pragma once

#include <vector>

#include "host/render/kernel_layout.hpp"
#include "host/render/mesh_store.hpp"
#include "host/render/plan.hpp"

namespace morphcl {

struct FrameTables {
  std::vector<layout::DrawConstants> draws;
  std::vector<layout::TargetConstants> targets;
  std::vector<layout::LightConstants> lights;
  std::vector<layout::uint> group_draw;
  std::vector<layout::BlockConstants> blocks;
  bool any_flat = false, any_smooth = false, any_colors = false;
};

// Error(bad_input) when the frame has more vertices or primitives than ids can number.
FrameTables make_frame_tables(const FramePlan& plan, const MeshStore& meshes);

// Grid, depth and light constants; what depends on pools and chunks is filled in by the renderer.
layout::FrameConstants make_frame_constants(const FramePlan& plan, std::size_t row_pitch);

}  // namespace morphcl
