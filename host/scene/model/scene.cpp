#include "host/scene/model/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "host/error.hpp"

namespace morphcl {

namespace {

[[noreturn]] void fail(const std::string& message) { throw Error(ErrorKind::bad_input, "", message); }

void check_image(const ImageSettings& image) {
  for (const int size : {image.width, image.height})
    if (size < 1 || size > max_image_size)
      fail(fmt::format("an image of {} x {} pixels; width and height reach from 1 to {}", image.width, image.height,
                       max_image_size));
  if (!image.color && !image.depth) fail("no channel is asked for; choose RGBA, Z or both");
}

void check_object(const Scene& scene, std::size_t index) {
  const Object& object = scene.objects[index];
  const std::string name = fmt::format("object {} \"{}\"", index, object.name);
  if (object.mesh < 0 || static_cast<std::size_t>(object.mesh) >= scene.meshes.size())
    fail(fmt::format("{}: mesh {} of {}", name, object.mesh, scene.meshes.size()));
  if (object.node < 0 || static_cast<std::size_t>(object.node) >= scene.timeline.nodes.size())
    fail(fmt::format("{}: node {} of {}", name, object.node, scene.timeline.nodes.size()));
  for (int c = 0; c < 4; ++c)
    if (!std::isfinite(object.material.base_color[c])) fail(fmt::format("{}: the base colour is not finite", name));

  const MorphWeights& weights = scene.timeline.weights[index];
  const std::size_t targets = scene.meshes[static_cast<std::size_t>(object.mesh)].targets.size();
  if (weights.weights.size() != targets)
    fail(fmt::format("{}: {} weights for {} morph targets", name, weights.weights.size(), targets));
  for (const double weight : weights.weights)
    if (!std::isfinite(weight)) fail(fmt::format("{}: a morph weight is not finite", name));
  for (const WeightTrack& track : weights.tracks) {
    const auto width = static_cast<std::size_t>(track.track.width());
    if (track.first_target < 0 || track.track.empty() || static_cast<std::size_t>(track.first_target) + width > targets)
      fail(fmt::format("{}: a weight track drives targets {} to {} of {}", name, track.first_target,
                       track.first_target + track.track.width() - 1, targets));
  }
}

}  // namespace

void validate(const Scene& scene) {
  check_image(scene.image);
  frame_numbers(scene.frames);
  for (const Mesh& mesh : scene.meshes) validate(mesh);
  scene.timeline.validate();
  if (scene.timeline.weights.size() != scene.objects.size())
    fail(fmt::format("{} lists of morph weights for {} objects", scene.timeline.weights.size(), scene.objects.size()));
  for (std::size_t i = 0; i < scene.objects.size(); ++i) check_object(scene, i);
}

}  // namespace morphcl
