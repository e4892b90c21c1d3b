#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <unordered_map>

#include "host/error.hpp"
#include "host/geometry/bounds.hpp"
#include "host/math/inverse.hpp"
#include "host/math/projection.hpp"
#include "host/math/rounding.hpp"
#include "host/render/plan.hpp"
#include "host/render/raster_grid.hpp"

namespace morphcl {

namespace {

Row to_row(const glm::dmat4& m, int row) {
  return {to_fp32(m[0][row]), to_fp32(m[1][row]), to_fp32(m[2][row]), to_fp32(m[3][row])};
}

std::array<float, 3> to_array(const glm::dvec3& v) { return {to_fp32(v.x), to_fp32(v.y), to_fp32(v.z)}; }

// How the view volume's depth is measured. Perspective: reversed and without a far plane in the matrix, depth = near /
// w, 1 on the near plane, 0 at infinity, so fp32 is dense where the distances are large. Parallel: depth = z in eye
// space.
struct DepthRow {
  glm::dvec4 row;  // of eye space
  std::array<float, 3> near_plane;
  float near_w, near_depth, far_depth, near;
};

DepthRow depth_row(const Projection& projection) {
  const double near = near_distance(projection), far = far_distance(projection);
  if (is_parallel(projection)) {
    const float near_depth = to_fp32(-near);
    return {{0, 0, 1, 0}, {-1.0f, 0.0f, near_depth}, 1.0f, near_depth, to_fp32(-far), 0.0f};
  }
  const float near_w = to_fp32(near);
  if (!(near_w >= 1e-30f)) throw Error(ErrorKind::bad_input, "", fmt::format("near = {} is below 1e-30", near));
  return {{0, 0, 0, near_w}, {0.0f, 1.0f, -near_w}, near_w, 1.0f, std::isinf(far) ? 0.0f : to_fp32(near / far), near_w};
}

enum class Side { inside, touching, outside };

// Where the corners of a box lie, in clip space, relative to a half-space; boxes are convex, so their insides follow.
class BoxInClipSpace {
 public:
  BoxInClipSpace(const Box& box, const glm::dmat4& object_to_clip) {
    for (int i = 0; i < 8; ++i) corners_[i] = object_to_clip * glm::dvec4(box.corner(i), 1.0);
  }
  Side side(const glm::dvec4& plane) const {
    int inside = 0;
    for (const glm::dvec4& corner : corners_) {
      // fp32 arithmetic of the renderers may differ by some ulp of the largest term: stay on the careful side.
      const double slack = 1e-5 * (std::abs(plane.x * corner.x) + std::abs(plane.y * corner.y) +
                                   std::abs(plane.z * corner.z) + std::abs(plane.w * corner.w));
      const double distance = glm::dot(plane, corner);
      if (distance > slack)
        ++inside;
      else if (distance > -slack)
        return Side::touching;
    }
    return inside == 8 ? Side::inside : inside == 0 ? Side::outside : Side::touching;
  }

 private:
  glm::dvec4 corners_[8];
};

struct Volume {
  std::vector<glm::dvec4> view, clip;  // planes of clip space: the picture's edges; near and guard band
};

Volume volume(const DepthRow& depth, const RasterGrid& grid) {
  const glm::dvec4 near(0, 0, depth.near_plane[0], depth.near_plane[1]);
  const double constant = depth.near_plane[2];
  // Clip coordinates carry no constant; w is 1 in parallel projections, and in perspective the constant is -near = -z.
  const glm::dvec4 near_plane =
      near + (depth.near_plane[0] != 0 ? glm::dvec4(0, 0, 0, constant) : glm::dvec4(0, 0, -1, 0));
  const glm::dvec4 far_plane(0, 0, 1, -depth.far_depth);
  Volume v;
  v.view = {near_plane, far_plane, {1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}};
  v.clip = {
      near_plane, {1, 0, 0, grid.guard_x}, {-1, 0, 0, grid.guard_x}, {0, 1, 0, grid.guard_y}, {0, -1, 0, grid.guard_y}};
  return v;
}

std::vector<ActiveTarget> active_targets(const Mesh& mesh, const std::vector<double>& weights) {
  std::vector<ActiveTarget> active;
  for (std::size_t i = 0; i < mesh.targets.size(); ++i) {
    const float weight = to_fp32(weights[i]);
    if (weight == 0.0f) continue;
    const bool absolute = mesh.targets[i].form == TargetForm::absolute;
    active.push_back({static_cast<int>(i), weight, absolute ? -weight : 0.0f});
  }
  return active;
}

struct Counts {
  int hidden = 0, outside = 0, empty = 0, idle_targets = 0, used_targets = 0;
};

}  // namespace

struct Planner::Impl {
  explicit Impl(const Scene& s) : scene(s) {
    bounds.reserve(s.meshes.size());
    for (const Mesh& mesh : s.meshes) bounds.emplace_back(mesh);
  }

  FramePlan plan(std::int64_t frame) const;
  void add_lights(const FrameState& state, FramePlan& plan) const;
  Draw make_draw(const Object& object, const glm::dmat4& object_to_eye, const glm::dmat4& eye_to_clip,
                 const std::vector<double>& weights, const FramePlan& plan) const;

  const Scene& scene;
  std::vector<MorphBounds> bounds;
  const std::uint64_t number = next_number();

 private:
  static std::uint64_t next_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }
};

void Planner::Impl::add_lights(const FrameState& state, FramePlan& plan) const {
  plan.ambient = to_array(state.ambient);
  const glm::dmat4& to_eye = state.camera.world_to_eye;
  for (const LightState& light : state.lights) {
    if (light.color == glm::dvec3(0.0)) continue;
    const bool directional = light.kind == LightKind::directional;
    plan.lights.push_back({light.kind, to_array(glm::dvec3(to_eye * glm::dvec4(light.vector, directional ? 0.0 : 1.0))),
                           to_array(light.color), light.falloff});
  }
}

Draw Planner::Impl::make_draw(const Object& object, const glm::dmat4& object_to_eye, const glm::dmat4& eye_to_clip,
                              const std::vector<double>& weights, const FramePlan& plan) const {
  Draw draw;
  draw.mesh = &scene.meshes[object.mesh];
  draw.targets = active_targets(*draw.mesh, weights);
  draw.double_sided = object.material.double_sided;
  draw.mirrored = glm::determinant(glm::dmat3(object_to_eye)) < 0.0;
  draw.vertex_colors = !draw.mesh->colors.empty();
  const glm::dvec4& base = object.material.base_color;
  draw.base_color = {to_fp32(base.r), to_fp32(base.g), to_fp32(base.b), to_fp32(base.a)};

  draw.shading = object.material.shading;
  if (draw.shading == Shading::smooth && draw.mesh->normals.empty()) draw.shading = Shading::flat;
  if (draw.shading == Shading::wireframe) draw.vertex_colors = false;
  if (plan.lights.empty() && (draw.shading == Shading::smooth || draw.shading == Shading::flat)) {
    // Without lights every normal gives the same: the ambient light goes into the base colour.
    draw.shading = Shading::unlit;
    for (int i = 0; i < 3; ++i) draw.base_color[i] = to_fp32(double{draw.base_color[i]} * double{plan.ambient[i]});
  }

  const glm::dmat4 object_to_clip = eye_to_clip * object_to_eye;
  for (int row = 0; row < 4; ++row) draw.object_to_clip[row] = to_row(object_to_clip, row);
  for (int row = 0; row < 3; ++row) draw.object_to_eye[row] = to_row(object_to_eye, row);
  const glm::dmat3 normals = normal_matrix(object_to_eye);
  for (int row = 0; row < 3; ++row)
    draw.normal_to_eye[row] = {to_fp32(normals[0][row]), to_fp32(normals[1][row]), to_fp32(normals[2][row])};
  return draw;
}

namespace {

std::string plural(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void add_notes(const Scene& scene, const Counts& counts, FramePlan& plan) {
  const auto note = [&](std::string item, bool done, std::string reason) {
    plan.notes.push_back({std::move(item), done, std::move(reason)});
  };
  note("RGBA", plan.color, plan.color ? "asked for" : "not among the channels");
  note("Z", plan.depth, plan.depth ? "asked for" : "not among the channels");
  note("objects", !plan.draws.empty(), fmt::format("{} of {} drawn", plan.draws.size(), scene.objects.size()));
  if (counts.outside)
    note("objects out of view", false, fmt::format("{}: their bounds miss the view", plural(counts.outside, "object")));
  if (counts.hidden) note("hidden objects", false, plural(counts.hidden, "object"));
  if (counts.empty) note("empty objects", false, plural(counts.empty, "object") + " without anything to draw");
  note("morph targets", counts.used_targets > 0,
       counts.used_targets > 0 ? plural(counts.used_targets, "active target") : "no weight differs from 0");
  if (counts.idle_targets)
    note("idle morph targets", false, fmt::format("{} of weight 0: not read", plural(counts.idle_targets, "target")));

  bool smooth = false, flat = false, tinted = false, lines = false;
  for (const Draw& draw : plan.draws) {
    smooth |= draw.shading == Shading::smooth, flat |= draw.shading == Shading::flat;
    lines |= draw.shading == Shading::wireframe, tinted |= draw.vertex_colors;
  }
  note("lights", !plan.lights.empty() && (smooth || flat),
       plan.lights.empty() ? "no light in the scene: ambient light is part of the colour"
       : smooth || flat    ? plural(plan.lights.size(), "light")
                           : "nothing that is lit");
  note("vertex normals", smooth, smooth ? "smooth shading" : "no smooth shading");
  note("face light", flat, flat ? "flat shading: once a face" : "no flat shading");
  note("vertex colours", tinted, tinted ? "the mesh has them" : "no mesh has them");
  note("lines", lines, lines ? "wireframe shading" : "no wireframe shading");
  note("perspective divide", !plan.parallel, plan.parallel ? "orthographic: w is 1" : "perspective");
  note("clipping", plan.clips,
       plan.clips ? "something may touch the near plane or the guard band" : "nothing comes near a clip plane");
}

}  // namespace

FramePlan Planner::Impl::plan(std::int64_t frame) const {
  const FrameState state = evaluate(scene.timeline, frame);
  FramePlan plan;
  plan.planner = number;
  plan.frame = frame;
  plan.width = scene.image.width, plan.height = scene.image.height;
  plan.color = scene.image.color, plan.depth = scene.image.depth;

  const Projection& projection = state.camera.projection;
  const DepthRow depth = depth_row(projection);
  plan.parallel = is_parallel(projection);
  plan.near_plane = depth.near_plane;
  plan.near_w = depth.near_w, plan.near_depth = depth.near_depth, plan.far_depth = depth.far_depth,
  plan.near = depth.near;

  const glm::dmat4 ndc = projection_matrix(projection, static_cast<double>(plan.width) / plan.height);
  glm::dmat4 eye_to_clip = ndc;
  for (int column = 0; column < 4; ++column) eye_to_clip[column][2] = depth.row[column];
  // x_ndc = (P00 x + P02 z + P03) / w, and z = -d: solved for the eye's x at distance d.
  const auto ray = [&](int axis, double pixel_scale, double pixel_offset, int at) {
    const double shift = plan.parallel ? -ndc[3][axis] : ndc[2][axis];
    plan.ray[at] = to_fp32(pixel_scale / ndc[axis][axis]);
    plan.ray[at + 1] = to_fp32((pixel_offset + shift) / ndc[axis][axis]);
  };
  ray(0, 2.0 / plan.width, -1.0, 0);
  ray(1, -2.0 / plan.height, 1.0, 2);
  plan.world_to_eye = state.camera.world_to_eye;
  plan.world_to_ndc = ndc * state.camera.world_to_eye;

  add_lights(state, plan);
  const Volume planes = volume(depth, RasterGrid(plan.width, plan.height));
  Counts counts;
  plan.clips = false;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const Mesh& mesh = scene.meshes[object.mesh];
    if (!state.node_visible[object.node]) {
      ++counts.hidden;
      continue;
    }
    if (object.material.shading == Shading::wireframe ? mesh.edges.empty() && mesh.triangles.empty()
                                                      : mesh.triangles.empty()) {
      ++counts.empty;
      continue;
    }
    const glm::dmat4 object_to_eye = state.camera.world_to_eye * state.node_to_world[object.node];
    const BoxInClipSpace box(bounds[object.mesh].at(state.weights[i]), eye_to_clip * object_to_eye);
    bool outside = false, clips = false;
    for (const glm::dvec4& plane : planes.view) outside |= box.side(plane) == Side::outside;
    if (outside) {
      ++counts.outside;
      continue;
    }
    for (const glm::dvec4& plane : planes.clip) clips |= box.side(plane) != Side::inside;
    plan.clips |= clips;
    try {
      plan.draws.push_back(make_draw(object, object_to_eye, eye_to_clip, state.weights[i], plan));
    } catch (const Error& error) {
      throw Error(ErrorKind::bad_input, fmt::format("frame {}", frame),
                  fmt::format("object \"{}\": {}", object.name, error.message()));
    }
    const int used = static_cast<int>(plan.draws.back().targets.size());
    counts.used_targets += used;
    counts.idle_targets += static_cast<int>(mesh.targets.size()) - used;
  }
  add_notes(scene, counts, plan);
  return plan;
}

Planner::Planner(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Planner::~Planner() = default;
FramePlan Planner::plan(std::int64_t frame) const { return impl_->plan(frame); }

FramePlan plan_frame(const Scene& scene, std::int64_t frame) { return Planner(scene).plan(frame); }

}  // namespace morphcl
