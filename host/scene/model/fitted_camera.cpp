#include "host/scene/model/fitted_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "anim/elastic.hpp"
#include "anim/spring.hpp"
#include "host/geometry/bounds.hpp"
#include "morphcl/camera.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr double fovy_degrees = 45, used_part = 0.7;
constexpr std::size_t max_samples = 101, max_object_samples = 500'000;
const glm::dvec3 view_from(1, 0.8, 1.7);

bool moves(const Scene& scene) {
  const Timeline& timeline = scene.timeline;
  const auto node_moves = [](const Node& node) {
    return !node.translation_track.empty() || !node.rotation_track.empty() || !node.scale_track.empty() ||
           !node.visible_track.empty();
  };
  const auto morphs = [](const Object& object) { return !object.morph.tracks.empty(); };
  return std::any_of(timeline.nodes.begin(), timeline.nodes.end(), node_moves) ||
         std::any_of(scene.objects.begin(), scene.objects.end(), morphs);
}

// Frames at which the bounds are taken.
std::vector<std::int64_t> sample_frames(const Scene& scene) {
  const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  if (!moves(scene)) return {frames.front()};
  const std::size_t affordable = max_object_samples / std::max<std::size_t>(scene.objects.size(), 1);
  const std::size_t samples = std::min(frames.size(), std::clamp<std::size_t>(affordable, 2, max_samples));
  std::vector<std::int64_t> chosen;
  for (std::size_t i = 0; i < samples; ++i)
    chosen.push_back(frames[samples == 1 ? 0 : i * (frames.size() - 1) / (samples - 1)]);
  return chosen;
}

// The support of a set of points in the directions that bound the view pyramid.
class PyramidSupport {
 public:
  explicit PyramidSupport(const glm::dvec2& slope) : slope_(slope) {
    reach_.fill(-std::numeric_limits<double>::infinity());
  }

  void include(const glm::dvec3& p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return;
    box_.include(p);
    const double x = p.x / slope_.x, y = p.y / slope_.y;
    const std::array<double, 4> reached = {p.z + x, p.z - x, p.z + y, p.z - y};
    for (std::size_t i = 0; i < reach_.size(); ++i) reach_[i] = std::max(reach_[i], reached[i]);
  }
  const Box& box() const { return box_; }
  // The eye from which the points just fit.
  glm::dvec3 eye() const {
    const double z = std::max(0.5 * reach_[0] + 0.5 * reach_[1], 0.5 * reach_[2] + 0.5 * reach_[3]);
    return {slope_.x * (0.5 * reach_[0] - 0.5 * reach_[1]), slope_.y * (0.5 * reach_[2] - 0.5 * reach_[3]), z};
  }

 private:
  glm::dvec2 slope_;
  Box box_;
  std::array<double, 4> reach_;
};

void include(const Box& box, const glm::dmat4& matrix, PyramidSupport& support) {
  for (int i = 0; i < 8; ++i) support.include(glm::dvec3(matrix * glm::dvec4(box.corner(i), 1.0)));
}

PyramidSupport support_of(const Scene& scene, const glm::dmat4& to_eye_axes, const glm::dvec2& slope) {
  std::vector<MorphBounds> bounds;
  bounds.reserve(scene.meshes.size());
  for (const Mesh& mesh : scene.meshes) bounds.emplace_back(mesh);
  PyramidSupport support(slope);
  for (const std::int64_t frame : sample_frames(scene)) {
    const FrameState state = evaluate(scene.timeline, frame);
    for (const Object& object : scene.objects) {
      const auto node = static_cast<std::size_t>(object.node);
      if (!state.node_visible[node]) continue;
      const Box box =
          bounds[static_cast<std::size_t>(object.mesh)].at(weights_at(object.morph, scene.timeline.time, frame));
      include(box, to_eye_axes * state.node_to_world[node], support);
    }
  }
  if (support.box().empty()) include({glm::dvec3(-1), glm::dvec3(1)}, to_eye_axes, support);
  return support;
}

}  // namespace

Camera fitted_camera(const Scene& scene) {
  const glm::dmat4 axes(glm::dmat3(look_at(view_from, glm::dvec3(0), glm::dvec3(0, 1, 0)).world_to_eye));
  const SinCos half = sin_cos_degrees(fovy_degrees / 2);
  const double slope = used_part * half.sin / half.cos;
  const PyramidSupport support = support_of(scene, axes, {slope * scene.image.width / scene.image.height, slope});

  // A point, or a line along the view, would be looked at from itself: keep the size of the thing as a distance, or
  // what fp64 can tell apart so far from the origin.
  const Box& box = support.box();
  const glm::dvec3 reach = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  double radius = std::max(sphere_of(box).radius, 1e-6 * std::max({reach.x, reach.y, reach.z}));
  if (radius == 0) radius = 1;
  glm::dvec3 eye = support.eye();
  eye.z = std::max(eye.z, box.upper.z + radius);

  const glm::dmat3 to_world = glm::transpose(glm::dmat3(axes));
  Camera camera;
  camera.projection = Perspective{
      .fovy_degrees = fovy_degrees, .near = 0.5 * (eye.z - box.upper.z), .far = eye.z - box.lower.z + radius};
  camera.eye = to_world * eye;
  camera.target = to_world * glm::dvec3(eye.x, eye.y, box.center().z);
  return camera;
}

Light key_light() {
  Light light;
  light.vector = {0.4, 0.7, 0.9};
  return light;
}

FrameRange animation_range(const Scene& scene, std::vector<std::string>& warnings) {
  const Timeline& timeline = scene.timeline;
  std::int64_t last_tick = 0;
  const auto include_track = [&](const Track& track, std::int64_t ticks_after = 0) {
    if (!track.empty()) last_tick = std::max(last_tick, track.end_tick() + ticks_after);
  };
  for (const Node& node : timeline.nodes)
    for (const Track* track : {&node.translation_track, &node.rotation_track, &node.scale_track, &node.visible_track})
      include_track(*track);
  for (const Object& object : scene.objects) {
    const MorphWeights& weights = object.morph;
    // An elastic object goes on until its slowest springs have settled.
    const double swinging = weights.elastic ? settling_seconds(anchor_spring(*weights.elastic)) : 0;
    for (const WeightTrack& track : weights.tracks)
      include_track(track.track, timeline.time.seconds_to_ticks(swinging));
  }
  const Camera& camera = timeline.camera;
  for (const Track* track : {&camera.eye_track, &camera.target_track, &camera.up_track, &camera.fovy_track,
                             &camera.fovx_track, &camera.near_track, &camera.far_track})
    include_track(*track);
  for (const Light& light : timeline.lights)
    for (const Track* track : {&light.vector_track, &light.color_track}) include_track(*track);

  const std::int64_t last = last_tick / timeline.time.ticks_per_frame();
  if (last < max_frame_count) return {.first = 0, .last = last, .step = 1};
  warnings.push_back(fmt::format("the animation has {} frames; the first {} are drawn", last + 1, max_frame_count));
  return {.first = 0, .last = max_frame_count - 1, .step = 1};
}

void complete_scene(Scene& scene, const Given& given) {
  if (!given.lights) scene.timeline.lights.push_back(key_light());
  if (!given.frames) scene.frames = {animation_range(scene, scene.warnings)};
  if (!given.camera) scene.timeline.camera = fitted_camera(scene);
}

}  // namespace morphcl
