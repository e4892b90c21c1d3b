#include "host/scene/model/fitted_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "anim/elastic.hpp"
#include "anim/spring.hpp"
#include "anim/timeline_at.hpp"
#include "host/scene/model/drawn_points.hpp"
#include "host/scene/model/outline_fit.hpp"
#include "morphcl/camera.hpp"

namespace morphcl {

namespace {

constexpr double used_part = 0.8;  // of the picture's width or height
// An eye nearer than this part of the scene's radius looks at a point, or along a line.
constexpr double min_distance_in_radii = 1e-3;
// Of the scene's distance from the origin: what is smaller fp64 does not draw in its place.
constexpr double min_radius = 1e-6;

// The corners of a cube of half-edge 1: what is looked at where nothing is drawn.
glm::dvec3 farthest_corner(const glm::dmat3& to_eye_axes, const glm::dvec3& direction) {
  const glm::dvec3 in_world = direction * to_eye_axes;
  return to_eye_axes * glm::dvec3(in_world.x < 0 ? -1 : 1, in_world.y < 0 ? -1 : 1, in_world.z < 0 ? -1 : 1);
}

// Places the eye and fits the projection.
class Fitter {
 public:
  Fitter(const Farthest& points, const CameraFit& fit, double aspect)
      : points_(points), fit_(fit), aspect_(aspect), depth_(extent_along(points, {0, 0, 1})) {
    const Extent width = extent_along(points, {1, 0, 0}), height = extent_along(points, {0, 1, 0});
    double farthest = 0;
    for (const Extent& extent : {width, height, depth_})
      farthest = std::max({farthest, std::abs(extent.lower), std::abs(extent.upper)});
    radius_ =
        std::max(0.5 * glm::length(glm::dvec3(width.size(), height.size(), depth_.size())), min_radius * farthest);
    if (radius_ == 0) radius_ = 1;
  }

  const glm::dvec3& eye() const { return eye_; }
  // The point in the middle of the scene's depth that is drawn in the middle.
  glm::dvec3 target() const { return {eye_.x, eye_.y, depth_.center()}; }

  void operator()(Perspective& lens) {
    look_through(fitted_window(lens, aspect_).window);
    set_distances(lens);
  }
  void operator()(HorizontalPerspective& lens) {
    look_through(fitted_window(lens, aspect_).window);
    set_distances(lens);
  }
  void operator()(Frustum& planes) {
    const Window window = usual_window();
    look_through(window);
    set_distances(planes);
    set_window(planes, window, planes.near);
  }
  void operator()(CentralProjection& planes) {
    const Window window = usual_window();
    look_through(window);
    set_distances(planes);
    planes.board = eye_.z - depth_.center();
    set_window(planes, window, planes.board);
  }
  void operator()(Orthographic& planes) { look_along(planes, {0, 0}); }
  void operator()(Oblique& planes) {
    look_along(planes, {planes.shear.x, planes.shear.y});
    planes.plane = eye_.z - depth_.center();
  }

 private:
  // 45 degrees, on the plane at distance 1.
  Window usual_window() const { return fitted_window(Perspective{}, aspect_).window; }

  void look_through(const Window& window) {
    const glm::dvec2 half(0.5 * (window.right - window.left), 0.5 * (window.top - window.bottom));
    const glm::dvec2 center(0.5 * (window.right + window.left), 0.5 * (window.top + window.bottom));
    eye_ = fitted_eye(points_, center, used_part * half, 0);
    // A point, or a line along the view, would be looked at from itself: keep the size of the thing as a distance.
    if (eye_.z - depth_.upper < min_distance_in_radii * radius_)
      eye_ = fitted_eye(points_, center, used_part * half, radius_);
  }

  // What lies d behind the plane through the middle of the depth is drawn d * shear away.
  template <typename Planes>
  void look_along(Planes& planes, const glm::dvec2& shear) {
    const Extent across = extent_along(points_, {1, 0, -shear.x}), up = extent_along(points_, {0, 1, -shear.y});
    eye_ = {across.center() + shear.x * depth_.center(), up.center() + shear.y * depth_.center(),
            depth_.upper + radius_};
    double half = 0.5 / used_part * std::max(up.size(), across.size() / aspect_);
    if (half < min_distance_in_radii * radius_) half = radius_;
    set_distances(planes);
    set_window(planes, {-half * aspect_, half * aspect_, -half, half}, 1);
  }

  // One that is given has the other on its side, even where it cuts all off.
  template <typename Planes>
  void set_distances(Planes& planes) const {
    const double near = 0.5 * (eye_.z - depth_.upper), far = eye_.z - depth_.lower + radius_;
    const double before_far = planes.far > 0 ? 0.5 * planes.far : planes.far - radius_;
    if (fit_.near) planes.near = fit_.far || near < planes.far ? near : before_far;
    if (fit_.far) planes.far = far > planes.near ? far : planes.near + radius_;
  }

  template <typename Planes>
  static void set_window(Planes& planes, const Window& window, double scale) {
    planes.left = scale * window.left;
    planes.right = scale * window.right;
    planes.bottom = scale * window.bottom;
    planes.top = scale * window.top;
  }

  const Farthest& points_;
  const CameraFit& fit_;
  double aspect_;
  Extent depth_;
  double radius_ = 1;
  glm::dvec3 eye_{0.0};
};

}  // namespace

void fit_camera(Scene& scene, const CameraFit& fit) {
  Camera& camera = scene.timeline.camera;
  const glm::dmat3 to_eye_axes(look_along(glm::dvec3(0), -fit.view.towards_eye, fit.view.up).world_to_eye);
  const DrawnPoints drawn(scene, to_eye_axes);
  const Farthest points = [&](const glm::dvec3& direction) {
    return drawn.empty() ? farthest_corner(to_eye_axes, direction) : drawn.farthest(direction);
  };
  // A field of view that moves is the first frame's.
  if (!camera.fovy_track.empty() || !camera.fovx_track.empty()) {
    const std::int64_t first = frame_numbers(scene.frames).front();
    camera.projection = evaluate_camera(camera, glm::dmat4(1.0), tick_of(scene.timeline.time, first)).projection;
  }
  Fitter fitter(points, fit, static_cast<double>(scene.image.width) / scene.image.height);
  std::visit(fitter, camera.projection);
  const glm::dmat3 to_world = glm::transpose(to_eye_axes);
  camera.up = fit.view.up;
  camera.eye = to_world * fitter.eye();
  camera.target = to_world * fitter.target();
}

std::vector<Light> default_lights() {
  const auto from = [](const glm::dvec3& direction, double intensity) {
    Light light;
    light.vector = direction;
    light.color = glm::dvec3(intensity);
    return light;
  };
  return {from({0.4, 0.7, 0.9}, 0.62), from({-0.6, -0.5, -0.75}, 0.34), from({0, 1, 0}, 0.2)};
}

FrameRange animation_range(const Scene& scene, std::vector<std::string>& warnings) {
  const Timeline& timeline = scene.timeline;
  std::int64_t last_tick = 0;
  const auto include_track = [&](const Track& track, std::int64_t ticks_after = 0) {
    if (!track.empty()) last_tick = std::max(last_tick, track.end_tick() + ticks_after);
  };
  for (const Node& node : timeline.nodes) for_each_track(node, [&](const Track& track) { include_track(track); });
  for (const Object& object : scene.objects) {
    const MorphWeights& weights = object.morph;
    // An elastic object goes on until its slowest springs have settled.
    const double swinging = weights.elastic ? settling_seconds(anchor_spring(*weights.elastic)) : 0;
    for (const WeightTrack& track : weights.tracks)
      include_track(track.track, timeline.time.seconds_to_ticks(swinging));
    include_track(object.material.base_color_track);
  }
  const Camera& camera = timeline.camera;
  for (const Track* track : {&camera.eye_track, &camera.target_track, &camera.up_track, &camera.fovy_track,
                             &camera.fovx_track, &camera.near_track, &camera.far_track})
    include_track(*track);
  for (const Light& light : timeline.lights) {
    for (const Track* track : {&light.vector_track, &light.color_track}) include_track(*track);
    if (light.spot) include_track(light.spot->target_track);
  }

  const std::int64_t last = last_tick / timeline.time.ticks_per_frame();
  if (last < max_frame_count) return {.first = 0, .last = last, .step = 1};
  warnings.push_back(fmt::format("the animation has {} frames; the first {} are drawn", last + 1, max_frame_count));
  return {.first = 0, .last = max_frame_count - 1, .step = 1};
}

void complete_scene(Scene& scene, const Given& given, const CameraFit& fit) {
  if (!given.lights) {
    scene.timeline.lights = default_lights();
    if (!given.ambient) scene.timeline.ambient = default_ambient;
  }
  if (!given.frames) scene.frames = {animation_range(scene, scene.warnings)};
  if (!given.camera) fit_camera(scene, fit);
}

}  // namespace morphcl
