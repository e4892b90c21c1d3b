#include "demos/viewer/frame_source.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "demos/viewer/eye_lights.hpp"
#include "demos/viewer/view_camera.hpp"
#include "morphcl/error.hpp"
#include "morphcl/job.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::viewer {
namespace {

std::vector<std::int64_t> frames_of(const Scene& scene) {
  std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  if (frames.empty()) throw Error(ErrorKind::bad_input, scene.name, "the shot has no frames; at least one is needed");
  return frames;
}

Scene with_background(Scene scene, const DemoSettings& settings) {
  if (settings.background) scene.image.background = Background{*settings.background, *settings.background};
  return scene;
}

}  // namespace

FrameSource::FrameSource(Scene scene, DemoSettings settings, DemoRenderer& renderer)
    : scene_(with_background(std::move(scene), settings)),
      settings_(std::move(settings)),
      renderer_(renderer),
      planner_(scene_),
      frames_(frames_of(scene_)),
      shot_camera_(scene_.timeline.camera),
      shot_lights_(scene_.timeline.lights),
      shot_image_(scene_.image),
      shot_hash_(scene_.content_hash) {}

DemoLimits FrameSource::limits() const {
  DemoLimits limits{.last_step = static_cast<int>(frames_.size()) - 1};
  if (settings_.turning) limits.turn_ticks = static_cast<int>(std::lround(360 / settings_.turning->degrees_a_tick));
  return limits;
}

View FrameSource::first_view() const {
  View view;
  view.projection = settings_.first_projection.value_or(shot_projection(scene_.timeline, frames_.front()));
  return view;
}

double FrameSource::frames_per_second() const {
  const TimeBase& time = scene_.timeline.time;
  return static_cast<double>(time.fps_numerator) / static_cast<double>(time.fps_denominator);
}

void FrameSource::show(const View& view, const Size& size, const ImageSettings& image) {
  scene_.image = image;
  scene_.image.width = size.width;
  scene_.image.height = size.height;
  scene_.timeline.camera = shot_camera_;
  scene_.timeline.lights = shot_lights_;
  scene_.content_hash = shot_hash_;
  const double aspect = static_cast<double>(size.width) / size.height;
  if (const auto camera = view_camera(scene_.timeline, frames_[view.step], view, settings_, aspect)) {
    if (settings_.lights_follow_eye)
      scene_.timeline.lights = lights_before_eye(scene_.timeline, frames_[view.step], *camera);
    scene_.timeline.camera = *camera;
    // A frame that the shot does not hold must not pass for one of its frames (`morphcl render --resume`).
    scene_.content_hash += fmt::format("+{},{},{},{},{},{},{}", settings_.name, static_cast<int>(view.projection),
                                       view.eye_steps, view.orbit_right, view.orbit_up, view.zoom, view.turn);
  }
}

const FrameBuffer& FrameSource::render(const View& view, const Size& size) {
  const bool same_size = rendered_ && Size{rendered_->width(), rendered_->height()} == size;
  if (same_size && rendered_view_ == view) return *rendered_;

  rendered_view_.reset();
  if (!same_size) rendered_ = std::make_unique<FrameBuffer>(size.width, size.height, ChannelSet{Channel::color});
  ImageSettings color_alone = shot_image_;
  color_alone.channels = {Channel::color};
  show(view, size, color_alone);

  const auto start = std::chrono::steady_clock::now();
  renderer_.for_next_frame().render(planner_.plan(frames_[view.step]), *rendered_);
  milliseconds_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  rendered_view_ = view;
  return *rendered_;
}

std::string FrameSource::export_frame(const View& view, const Size& size, const std::string& pattern) {
  show(view, size, shot_image_);
  RenderJob job;
  job.pattern = pattern;
  job.frames = {frames_[view.step]};
  const FrameResult result = run(job, scene_, renderer_.for_next_frame()).frames.at(0);
  if (result.status == FrameResult::Status::failed) {
    throw Error(static_cast<ErrorKind>(result.error_code), "", result.error);
  }
  return result.path;
}

}  // namespace morphcl::viewer
