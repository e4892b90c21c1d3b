#include "morphcl/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

[[noreturn]] void fail(const std::string& message) { throw Error(ErrorKind::bad_input, "", message); }

void check_background(const Background& background) {
  for (const glm::dvec3& color : {background.top, background.bottom})
    for (int c = 0; c < 3; ++c)
      if (!(color[c] >= 0 && color[c] <= max_background))
        fail(fmt::format("a background of {}; its colours reach from 0 to {}", color[c], max_background));
}

// Of what EXR files may round: an error of a channel that is not there means something else than what it says.
void check_errors(const ImageSettings& image) {
  const auto has = [&image](double error, Channel channel, const char* name) {
    if (error != 0 && !image.channels.contains(channel))
      fail(fmt::format("{} is {} and there is no channel {}; ask for {}, or leave it 0", name, error, name_of(channel),
                       name_of(channel)));
    return error != 0;
  };
  if (has(image.z_error, Channel::depth, "z_error")) mantissa_bits_for(image.z_error);
  if (has(image.p_error, Channel::position, "p_error")) mantissa_bits_for(image.p_error);
  if (has(image.n_error, Channel::normal, "n_error")) step_for(image.n_error);
}

void check_image(const ImageSettings& image) {
  for (const int size : {image.width, image.height})
    if (size < 1 || size > max_image_size)
      fail(fmt::format("an image of {} x {} pixels; width and height reach from 1 to {}", image.width, image.height,
                       max_image_size));
  if (image.channels.empty()) fail("no channel is asked for; choose RGBA, Z or others");
  if (std::ranges::find(depth_formats, image.depth_format) == depth_formats.end())
    fail(fmt::format("there is no depth buffer {}", static_cast<int>(image.depth_format)));
  if (image.background) check_background(*image.background);
  if (std::ranges::find(sample_counts, image.samples) == sample_counts.end())
    fail(fmt::format("{} samples a pixel; 1, 2, 4, 8 or 16 are possible", image.samples));
  if (std::ranges::find(visibility_methods, image.visibility) == visibility_methods.end())
    fail(fmt::format("there is no visibility method {}", static_cast<int>(image.visibility)));
  check_visibility(image);
  check_errors(image);
}
constexpr int last_shading = static_cast<int>(Shading::wireframe);
constexpr int last_alpha_mode = static_cast<int>(AlphaMode::opaque);

void check_object(const Scene& scene, std::size_t index) {
  const Object& object = scene.objects[index];
  const std::string name = fmt::format("object {} \"{}\"", index, object.name);
  if (object.mesh < 0 || static_cast<std::size_t>(object.mesh) >= scene.meshes.size())
    fail(fmt::format("{}: mesh {} of {}", name, object.mesh, scene.meshes.size()));
  if (object.node < 0 || static_cast<std::size_t>(object.node) >= scene.timeline.nodes.size())
    fail(fmt::format("{}: node {} of {}", name, object.node, scene.timeline.nodes.size()));
  if (const int shading = static_cast<int>(object.material.shading); shading < 0 || shading > last_shading)
    fail(fmt::format("{}: there is no shading {}", name, shading));
  for (int c = 0; c < 4; ++c)
    if (!std::isfinite(object.material.base_color[c])) fail(fmt::format("{}: the base colour is not finite", name));
  if (const double alpha = object.material.base_color.a; !(alpha >= 0 && alpha <= 1))
    fail(fmt::format("{}: the base colour's alpha is {}; it reaches from 0 to 1", name, alpha));
  if (const int mode = static_cast<int>(object.material.alpha_mode); mode < 0 || mode > last_alpha_mode)
    fail(fmt::format("{}: there is no alpha mode {}", name, mode));
  if (!std::isfinite(object.material.alpha_cutoff)) fail(fmt::format("{}: the alpha cutoff is not finite", name));

  if (const Track& track = object.material.base_color_track; !track.empty()) {
    if (track.width() != 3 && track.width() != 4)
      fail(fmt::format("{}: the base colour's track has {} components; it needs 3, or 4 with alpha", name,
                       track.width()));
    if (track.is_rotation()) fail(fmt::format("{}: the base colour's track is one of rotations", name));
  }

  if (const double width = object.material.line_width; !(width > 0 && width <= max_line_width))
    fail(fmt::format("{}: lines {} pixels wide; more than 0 to {} is possible", name, width, max_line_width));

  const MorphWeights& weights = object.morph;
  const std::size_t targets = scene.meshes[static_cast<std::size_t>(object.mesh)].targets.size();
  if (weights.weights.size() != targets)
    fail(fmt::format("{}: {} weights for {} morph targets", name, weights.weights.size(), targets));
  try {
    validate(weights);
  } catch (const Error& error) {
    fail(fmt::format("{}: {}", name, error.message()));
  }
}

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::usage, "", message); }

std::string names_of(const std::vector<MorphTarget>& targets) {
  std::string names;
  for (const MorphTarget& target : targets) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", target.name);
  return names.empty() ? "it has none" : "it has " + names;
}

}  // namespace

int Scene::add_object(std::string object_name, Mesh mesh, const CompositeTransform& placing) {
  meshes.push_back(std::move(mesh));
  return add_object(std::move(object_name), static_cast<int>(meshes.size()) - 1, placing);
}

int Scene::add_object(std::string object_name, int mesh, const CompositeTransform& placing) {
  if (mesh < 0 || static_cast<std::size_t>(mesh) >= meshes.size())
    refuse(fmt::format("object \"{}\": mesh {} of {}", object_name, mesh, meshes.size()));
  Node node;
  node.name = object_name;
  node.static_transform = placing.matrix();
  timeline.nodes.push_back(std::move(node));
  Object object;
  object.name = std::move(object_name);
  object.mesh = mesh;
  object.node = static_cast<int>(timeline.nodes.size()) - 1;
  object.morph.weights.assign(meshes[static_cast<std::size_t>(mesh)].targets.size(), 0.0);
  objects.push_back(std::move(object));
  return static_cast<int>(objects.size()) - 1;
}

void Scene::morph(int object, std::string_view target, Track track) {
  if (object < 0 || static_cast<std::size_t>(object) >= objects.size())
    refuse(fmt::format("object {} of {}", object, objects.size()));
  Object& morphed = objects[static_cast<std::size_t>(object)];
  const std::vector<MorphTarget>& targets = meshes.at(static_cast<std::size_t>(morphed.mesh)).targets;
  const auto found = std::find_if(targets.begin(), targets.end(),
                                  [&](const MorphTarget& candidate) { return candidate.name == target; });
  if (found == targets.end())
    refuse(fmt::format("object \"{}\" has no morph target \"{}\"; {}", morphed.name, target, names_of(targets)));
  if (track.width() != 1)
    refuse(fmt::format("the weight of target \"{}\" is one number; the track has {}", target, track.width()));
  morphed.morph.tracks.push_back({static_cast<int>(found - targets.begin()), std::move(track)});
}

void validate(const Scene& scene) {
  check_image(scene.image);
  if (!(scene.accuracy_pixels >= 0 && std::isfinite(scene.accuracy_pixels)))
    fail(fmt::format("an accuracy of {} pixels; a number from 0 is meant", scene.accuracy_pixels));
  if (!scene.frames.empty()) frame_numbers(scene.frames);
  for (const Mesh& mesh : scene.meshes) validate(mesh);
  validate(scene.timeline);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) check_object(scene, i);
}

void check_visibility(const ImageSettings& image) {
  if (image.visibility != VisibilityMethod::z_buffer && image.samples > 1)
    throw Error(ErrorKind::usage, "",
                fmt::format("visibility {} takes one sample a pixel, not {}; ask for samples 1, or for z-buffer",
                            name_of(image.visibility), image.samples));
}

}  // namespace morphcl
