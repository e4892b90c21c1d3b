#include "host/render/auto/frame_estimate.hpp"

namespace morphcl {

namespace {

// Seconds on one core of an AVX-512 server processor.
constexpr double each_pixel = 60e-9, each_vertex = 60e-9, each_target_vertex = 10e-9, each_triangle = 250e-9;
constexpr double device_launches = 0.3e-3;
constexpr double device_is_faster = 15;

}  // namespace

double estimated_reference_seconds(const FramePlan& plan, int threads) {
  // Vertices are for one thread, and each thread looks at every triangle.
  double alone = 0, shared = each_pixel * plan.samples * plan.width * plan.height;
  for (const Draw& draw : plan.draws) {
    const auto vertices = static_cast<double>(draw.mesh->positions.size());
    alone += vertices * (each_vertex + each_target_vertex * static_cast<double>(draw.targets.size()));
    alone += each_triangle * static_cast<double>(draw.mesh->triangles.size());
  }
  return alone + shared / threads;
}

double estimated_device_seconds(double reference_seconds) {
  return device_launches + reference_seconds / device_is_faster;
}

}  // namespace morphcl
