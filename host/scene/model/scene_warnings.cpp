#include "host/scene/model/scene_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "anim/node_sampler.hpp"
#include "anim/timeline_at.hpp"
#include "host/scene/model/model_choice.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

void warn_of_emptiness(Scene& scene) {
  if (!scene.objects.empty()) return;
  std::vector<std::string> others;
  for (const ModelPart& part : scene.parts)
    if (part.kind == ModelPart::Kind::scene && !part.used)
      others.push_back(fmt::format("{} '{}'", part.index, printable(part.name.substr(0, 60))));
  std::string line = "there is nothing to draw";
  if (!others.empty())
    line +=
        fmt::format("; the model has other scenes, by --scene or scene in a shot's object: {}",
                    fmt::join(others.begin(), others.begin() + std::min<std::ptrdiff_t>(8, std::ssize(others)), ", "));
  scene.warnings.push_back(std::move(line));
}

// The first of up to 101 frames, evenly spread, at which the camera's up is of no use.
void warn_of_up(Scene& scene) {
  const Camera& camera = scene.timeline.camera;
  if (camera.node >= 0) return;
  NodeSampler nodes(scene.timeline.nodes);
  const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  const bool moves = !camera.eye_track.empty() || !camera.target_track.empty() || !camera.up_track.empty() ||
                     (camera.parent >= 0 && !nodes.is_still(camera.parent));
  const std::size_t step = moves ? (frames.size() + 99) / 100 : frames.size();
  for (std::size_t i = 0; i < frames.size(); i += step) {
    const std::int64_t tick = tick_of(scene.timeline.time, frames[i]);
    nodes.go_to(tick);
    const glm::dmat4 to_world = camera.parent < 0 ? glm::dmat4(1.0) : nodes.to_world(camera.parent);
    const CameraState state = evaluate_camera(camera, to_world, tick);
    if (!state.up_replaced) continue;
    const glm::dmat4& m = state.world_to_eye;
    scene.warnings.push_back(fmt::format("camera: at frame {} up lies along the view; ({:.6g}, {:.6g}, {:.6g}) is used",
                                         frames[i], m[0][1], m[1][1], m[2][1]));
    return;
  }
}

}  // namespace

void warn_of_oddities(Scene& scene) {
  warn_of_emptiness(scene);
  warn_of_up(scene);
}

}  // namespace morphcl
