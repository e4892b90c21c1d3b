#include "host/render/auto/frame_kernels.hpp"

#include <algorithm>
#include <string_view>

#include "host/device/cache_dir.hpp"
#include "host/render/frame/channel_passes.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl {

namespace {

constexpr std::size_t chunk_groups = 64;  // of primitives, below which a frame is one chunk (lay_out_bins)

std::size_t groups_of(std::size_t count) { return (count + layout::lanes - 1) / layout::lanes; }

// Edges that a wireframe shows, about: finding them takes longer than it is worth.
std::size_t primitive_count(const Draw& draw) {
  if (draw.shading != Shading::wireframe) return draw.mesh->triangles.size();
  return draw.mesh->edges.empty() ? draw.mesh->triangles.size() * 3 / 2 : draw.mesh->edges.size();
}

bool is_one_chunk(const FramePlan& plan) {
  std::size_t vertex_groups = 0, primitive_groups = 0;
  for (const Draw& draw : plan.draws) {
    vertex_groups += groups_of(draw.mesh->positions.size());
    primitive_groups += groups_of(primitive_count(draw));
  }
  return vertex_groups > 0 && vertex_groups <= layout::vertex_groups_per_chunk && primitive_groups < 2 * chunk_groups;
}

struct KernelCost {
  std::string_view name;
  double compile, store;  // seconds
};

// PoCL 3.1 on a core of an AVX-512 server processor: differences between processes that compile them and others. Of
// what compiling takes for a whole program each has a part.
constexpr KernelCost kernel_costs[] = {
    {"project_light_and_bin", 0.6, 0.5},
    {"project_vertices", 0.35, 0.3},
    {"count_clipped", 0.15, 0.1},
    {"clip_primitives", 0.25, 0.2},
    {"light_and_bin_primitives", 0.45, 0.4},
    {"bin_primitives", 0.4, 0.35},
    {"shade_tiles", 0.9, 0.8},
    {"project_light_and_bin_samples", 0.7, 0.6},
    {"light_and_bin_samples", 0.5, 0.45},
    {"bin_samples", 0.45, 0.4},
    {"shade_samples", 1.5, 1.2},
    {"shade_channels", 1.2, 1.0},
    {"project_next", 0.35, 0.3},
};
constexpr KernelCost unknown_kernel = {"", 0.5, 0.4};

const KernelCost& cost_of(const FrameKernel& kernel) {
  for (const KernelCost& cost : kernel_costs)
    if (cost.name == kernel.name) return cost;
  return unknown_kernel;
}

// Triangles without area: nothing of them is covered.
Mesh degenerate_mesh(std::size_t triangles) {
  Mesh mesh;
  mesh.positions.assign(3, glm::vec3(0));
  mesh.triangles.assign(triangles, glm::uvec3(0, 1, 2));
  return mesh;
}

// What kernels are compiled for, and which passes they belong to.
struct KernelVariant {
  DepthFormat depth_format;
  int samples;
  bool depth;
  bool blends;
  bool channels, velocity;  // beside colour and distance
};

FramePlan sample_plan(const Mesh& mesh, Shading shading, bool clips, const KernelVariant& variant) {
  FramePlan plan;
  plan.alone = true;
  plan.width = plan.height = layout::tile;
  plan.clips = clips;
  plan.depth_format = variant.depth_format;
  plan.samples = variant.samples;
  plan.channels.set(Channel::depth, variant.depth);
  plan.blends = variant.blends;
  plan.channels.set(Channel::coverage, variant.channels);
  plan.channels.set(Channel::velocity, variant.velocity);
  plan.keeps_vertices = plan.keeps_blank_tiles = false;
  plan.camera.near = plan.camera.near_depth = plan.camera.near_w = 1;
  Draw draw{};
  draw.mesh = &mesh;
  draw.shading = shading;
  draw.object_to_clip[3] = {0, 0, 0, 1};
  plan.draws.push_back(draw);
  if (variant.velocity) plan.next_draws = plan.draws;
  return plan;
}

KernelVariant variant_of(const FrameKernels& kernels) {
  KernelVariant variant{DepthFormat::reversed_float, 1, false, false, false, false};
  for (const FrameKernel& kernel : kernels)
    for (const DepthFormat format : depth_formats)
      for (const int samples : sample_counts)
        for (const bool blends : {false, true}) {
          if (kernel.options != kernel_options(format, samples, blends)) continue;
          variant.depth_format = format;
          variant.samples = std::max(variant.samples, samples);
          variant.blends = variant.blends || blends;
        }
  for (const FrameKernel& kernel : kernels) {
    variant.channels |= kernel.name == "shade_channels";
    variant.velocity |= kernel.name == "project_next";
  }
  variant.depth = variant.samples == 1 || std::any_of(kernels.begin(), kernels.end(), [](const FrameKernel& kernel) {
                    return kernel.name == "shade_tiles" || kernel.name == "bin_primitives";
                  });
  return variant;
}

}  // namespace

FrameKernels frame_kernels(const FramePlan& plan) {
  const std::string options = kernel_options(plan.depth_format, 1),
                    sampled = kernel_options(plan.depth_format, plan.samples);
  const bool several = plan.samples > 1, fused = !plan.clips && is_one_chunk(plan);
  const bool faces =
      std::any_of(plan.draws.begin(), plan.draws.end(), [](const Draw& draw) { return draw.shading == Shading::flat; });
  FrameKernels kernels;
  if (several) {
    kernels.insert({"shade_samples", "shade_samples", kernel_options(plan.depth_format, plan.samples, plan.blends)});
    kernels.insert({"bin_samples",
                    fused   ? "project_light_and_bin_samples"
                    : faces ? "light_and_bin_samples"
                            : "bin_samples",
                    sampled});
    if (draws_centres(plan)) kernels.insert({"bin_primitives", "bin_primitives", options});
  } else {
    kernels.insert({"bin_primitives",
                    fused   ? "project_light_and_bin"
                    : faces ? "light_and_bin_primitives"
                            : "bin_primitives",
                    options});
  }
  if (!several || draws_centres(plan))
    kernels.insert({"shade_tiles", "shade_tiles", kernel_options(plan.depth_format, 1, plan.blends)});
  if (!(plan.channels & (channels_of_samples | channels_of_centres)).empty())
    kernels.insert({"shade_channels", "shade_channels", options});
  if (plan.has(Channel::velocity)) kernels.insert({"project_next", "project_next", options});
  if (!fused) kernels.insert({"project_vertices", "project_vertices", options});
  if (plan.clips) {
    kernels.insert({"clip_primitives", "count_clipped", options});
    kernels.insert({"clip_primitives", "clip_primitives", options});
  }
  return kernels;
}

double compile_seconds(const FrameKernels& kernels) {
  double seconds = 0;
  for (const FrameKernel& kernel : kernels) seconds += cost_of(kernel).compile;
  return seconds;
}

double store_seconds(const FrameKernels& kernels) {
  if (pocl_cache_is_ours()) return 0;
  double seconds = 0;
  for (const FrameKernel& kernel : kernels) seconds += cost_of(kernel).store;
  return seconds;
}

KernelSamples::KernelSamples(const FrameKernels& kernels)
    : one_chunk_(degenerate_mesh(1)), many_chunks_(degenerate_mesh(2 * chunk_groups * layout::lanes)) {
  const auto wanted = [&kernels](std::string_view name) {
    return std::any_of(kernels.begin(), kernels.end(), [name](const FrameKernel& k) { return k.name == name; });
  };
  const KernelVariant variant = variant_of(kernels);
  const std::string_view fused = variant.samples > 1 ? "project_light_and_bin_samples" : "project_light_and_bin",
                         with_faces = variant.samples > 1 ? "light_and_bin_samples" : "light_and_bin_primitives",
                         plain = variant.samples > 1 ? "bin_samples" : "bin_primitives";
  const bool clips = wanted("count_clipped") || wanted("clip_primitives");
  const Mesh& in_stages = clips ? one_chunk_ : many_chunks_;
  const bool stages = clips || wanted("project_vertices"), faces = wanted(with_faces);
  if (wanted(fused)) plans_.push_back(sample_plan(one_chunk_, Shading::flat, false, variant));
  if (faces) plans_.push_back(sample_plan(in_stages, Shading::flat, clips, variant));
  // Where faces are as they were, the plain one comes with the others as well.
  if (wanted(plain) || (stages && !faces)) plans_.push_back(sample_plan(in_stages, Shading::unlit, clips, variant));
  if (plans_.empty() && !kernels.empty()) plans_.push_back(sample_plan(one_chunk_, Shading::flat, clips, variant));
}

}  // namespace morphcl
