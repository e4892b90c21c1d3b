#include "host/render/explain/workload.hpp"

#include <algorithm>

namespace morphcl {

namespace {

// Edges that wireframe draws, about: a closed mesh has half as many again as triangles.
double line_count(const Mesh& mesh) {
  return mesh.edges.empty() ? 1.5 * static_cast<double>(mesh.triangles.size()) : static_cast<double>(mesh.edges.size());
}

// Attributes that a target moves and the draw needs.
double moved_attributes(const MorphTarget& target, const Draw& draw) {
  return (target.positions.empty() || draw.displaced ? 0.0 : 1.0) +
         (target.normals.empty() || draw.shading != Shading::smooth ? 0.0 : 1.0) +
         (target.colors.empty() || !draw.vertex_colors ? 0.0 : 1.0);
}

void count_targets(const Draw& draw, double vertices, Workload& work) {
  for (const MorphTarget& target : draw.mesh->targets)
    work.idle_target_vertices += vertices * moved_attributes(target, draw);
  for (const ActiveTarget& active : draw.targets) {
    if (active.weight == 0.0f) continue;
    const double moved = vertices * moved_attributes(draw.mesh->targets[active.target], draw);
    work.target_vertices += moved;
    work.idle_target_vertices -= moved;
  }
}

void count_elastic(const DisplacedPositions& shape, Workload& work) {
  const auto masses = static_cast<double>(shape.masses);
  if (shape.method == ElasticMethod::modal) {
    work.modes += masses;
    work.modal_pairs += masses * masses;
  } else {
    work.stepped_masses += masses;
  }
}

}  // namespace

Workload count_work(const FramePlan& plan, const ScreenReach& reach) {
  Workload work;
  double smooth = 0, tinted = 0, blended = 0;
  for (const Draw& draw : plan.draws) {
    const auto vertices = static_cast<double>(draw.mesh->positions.size());
    const auto triangles = static_cast<double>(draw.mesh->triangles.size());
    work.draws += 1;
    work.vertices += vertices;
    if (draw.accuracy && draw.accuracy->form == VertexForm::pivot) work.pivot_vertices += vertices;
    if (draw.accuracy && draw.accuracy->form == VertexForm::two_float) work.two_float_vertices += vertices;
    count_targets(draw, vertices, work);
    if (draw.displaced) count_elastic(*draw.displaced, work);
    if (draw.shading == Shading::wireframe) {
      work.lines += line_count(*draw.mesh);
      continue;
    }
    work.triangles += triangles;
    if (draw.blended) blended += triangles;
    if (draw.shading == Shading::smooth) {
      work.smooth_vertices += vertices;
      smooth += triangles;
    }
    if (draw.shading == Shading::flat) work.flat_faces += triangles;
    if (draw.vertex_colors) {
      work.colored_vertices += vertices;
      tinted += triangles;
    }
  }
  if (work.triangles > 0) {
    work.smooth_share = smooth / work.triangles;
    work.tinted_share = tinted / work.triangles;
    work.blended_share = blended / work.triangles;
  }
  work.lights = static_cast<double>(plan.lights.size());
  work.pixels = static_cast<double>(plan.width) * plan.height;
  work.reached_pixels = reach.reached_pixels;
  work.bytes_per_pixel = static_cast<double>(pixel_bytes(plan.channels));
  return work;
}

SkippedWork count_skipped(const Scene& scene, const FramePlan& plan) {
  SkippedWork skipped;
  std::size_t next = 0;  // draws are in the scene's order
  for (std::size_t object = 0; object < scene.objects.size(); ++object) {
    if (next < plan.draws.size() && plan.draws[next].object == object) {
      ++next;
      continue;
    }
    const Mesh& mesh = scene.meshes[scene.objects[object].mesh];
    skipped.vertices += static_cast<double>(mesh.positions.size());
    skipped.triangles += static_cast<double>(mesh.triangles.size());
  }
  return skipped;
}

}  // namespace morphcl
