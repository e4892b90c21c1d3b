// The frames of a demo: a scene, a renderer, and the view that is asked for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "demos/viewer/demo_renderer.hpp"
#include "demos/viewer/demo_settings.hpp"
#include "demos/viewer/demo_state.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::viewer {

struct Size {
  int width = 0, height = 0;  // pixels, 1 to 16384
  bool operator==(const Size&) const = default;
};

class FrameSource {
 public:
  // Error(bad_input) when the scene has no frames.
  FrameSource(Scene scene, DemoSettings settings, DemoRenderer& renderer);
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  DemoLimits limits() const;
  View first_view() const;
  double frames_per_second() const;

  // The colour of a view. Rendered only when view or size differ from the last call's; valid until the next call.
  const FrameBuffer& render(const View& view, const Size& size);
  double milliseconds() const { return milliseconds_; }  // that the last rendering took: plan and kernels

  // Writes the view with the shot's own channels and compression, as `morphcl render` does; `pattern` as in
  // morphcl/job.hpp. Returns the path. Throws what writing and rendering throw.
  std::string export_frame(const View& view, const Size& size, const std::string& pattern);

 private:
  void show(const View& view, const Size& size, const ImageSettings& image);

  Scene scene_;  // camera, lights, image and hash are those of the view at hand
  const DemoSettings settings_;
  DemoRenderer& renderer_;
  const Planner planner_;                   // of scene_, whose meshes stay as they are
  const std::vector<std::int64_t> frames_;  // one a step
  const Camera shot_camera_;
  const std::vector<Light> shot_lights_;
  const ImageSettings shot_image_;
  const std::string shot_hash_;

  std::optional<View> rendered_view_;
  std::unique_ptr<FrameBuffer> rendered_;
  double milliseconds_ = 0;
};

}  // namespace morphcl::viewer
