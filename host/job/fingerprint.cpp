#include "morphcl/job.hpp"

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "host/image/pixel_hash.hpp"
#include "host/render/plan/transparency.hpp"
#include "host/scene/model/material_list.hpp"
#include "morphcl/version.hpp"

namespace morphcl {

namespace {

// Adds values one after the other. Structs are taken apart by structured bindings, which stop the build when a member
// is added that is not decided on here. Lists and texts begin with their length, so that no two scenes give the same
// bytes.
class SceneHasher {
 public:
  std::string hex() const { return hasher_.hex(); }

  template <class Value>
    requires(std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
  void add(Value value) {
    hasher_.add_row(&value, sizeof value);
  }
  void add(std::string_view text) {
    add(text.size());
    hasher_.add_row(text.data(), text.size());
  }
  template <glm::length_t size, class Real>
  void add(const glm::vec<size, Real>& vector) {
    hasher_.add_row(&vector, sizeof vector);
  }
  void add(const glm::dmat4& matrix) { hasher_.add_row(&matrix, sizeof matrix); }
  void add(const glm::dquat& quaternion) { hasher_.add_row(&quaternion, sizeof quaternion); }
  template <class Value>
  void add(const std::vector<Value>& values) {
    add(values.size());
    if constexpr (packed<Value>)
      hasher_.add_row(values.data(), values.size() * sizeof(Value));
    else
      for (const Value& value : values) add(value);
  }
  template <class... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }

  void add(const Spring& spring) { add_all(spring.angular_frequency, spring.damping_ratio); }
  void add(const Track& track) {
    add_all(track.interpolation(), track.width(), track.is_rotation(), track.ticks().size(), track.values().size());
    hasher_.add_row(track.ticks().data(), track.ticks().size_bytes());
    hasher_.add_row(track.values().data(), track.values().size_bytes());
    if (track.key_count() > 1) add(track.seconds_from_key(0, track.last_tick()));
    if (const auto spring = track.spring()) add(*spring);
  }
  void add(const WeightTrack& driven) {
    const auto& [first_target, track] = driven;
    add_all(first_target, track);
  }
  void add(const Elastic& elastic) {
    const auto& [anchor, stiffness, damping, edge_damping, rest, rule] = elastic;
    add_all(anchor, stiffness, damping, edge_damping, rest, rule);
  }
  void add(const MorphWeights& morph) {
    const auto& [weights, tracks, elastic] = morph;
    add_all(weights, tracks, elastic.has_value());
    if (elastic) add(*elastic);
  }
  void add(const DrivenParameters& driven) {
    const auto& [first, track] = driven;
    add_all(first, track);
  }
  void add(const AnimatedStep& step) {
    const auto& [kind, parameters, tracks, of_axes, constant] = step;
    add(kind);
    for (const double parameter : parameters) add(parameter);
    add_all(tracks, of_axes, constant.matrix());
  }
  void add(const Node& node) {
    const auto& [name, parent, matrix, translation, rotation, scale, moves, turns, grows, shows, steps] = node;
    add_all(parent, matrix, translation, rotation, scale, moves, turns, grows, shows);
    if (!steps.empty()) add_all(std::string_view("steps"), steps.steps());
  }
  void add(const Perspective& projection) {
    const auto& [fovy, near, far] = projection;
    add_all(fovy, near, far);
  }
  void add(const HorizontalPerspective& projection) {
    const auto& [fovx, near, far] = projection;
    add_all(fovx, near, far);
  }
  void add(const Frustum& projection) {
    const auto& [left, right, bottom, top, near, far, fit] = projection;
    add_all(left, right, bottom, top, near, far, fit);
  }
  void add(const CentralProjection& projection) {
    const auto& [left, right, bottom, top, near, far, board, fit] = projection;
    add_all(left, right, bottom, top, near, far, board, fit);
  }
  void add(const Orthographic& projection) {
    const auto& [left, right, bottom, top, near, far, fit] = projection;
    add_all(left, right, bottom, top, near, far, fit);
  }
  void add(const Oblique& projection) {
    const auto& [left, right, bottom, top, near, far, shear, plane, fit] = projection;
    add_all(left, right, bottom, top, near, far, shear.x, shear.y, plane, fit);
  }
  void add(const Camera& camera) {
    const auto& [projection, node, parent, eye, target, up, eye_track, target_track, up_track, fovy, fovx, near, far] =
        camera;
    add(projection.index());
    std::visit([this](const auto& kind) { add(kind); }, projection);
    add_all(node, eye, target, up, eye_track, target_track, up_track, fovy, fovx, near, far);
    if (parent >= 0) add_all(std::string_view("camera parent"), parent);
  }
  void add(const Light& light) {
    const auto& [kind, vector, color, falloff, vector_track, color_track, node, spot] = light;
    add_all(kind, vector, color, falloff, vector_track, color_track);
    if (node >= 0) add_all(std::string_view("light node"), node);
    if (!spot) return;
    const auto& [target, target_track, inner, outer] = *spot;
    add_all(std::string_view("spot"), target, target_track, inner, outer);
  }
  void add(const Timeline& timeline) {
    const auto& [time, nodes, camera, lights, ambient] = timeline;
    add_all(time.fps_numerator, time.fps_denominator, nodes, camera, lights, ambient);
  }
  void add(const MorphTarget& target) {
    const auto& [name, form, positions, normals, colors] = target;
    add_all(form, positions, normals, colors);
  }
  void add(const Mesh& mesh) {
    const auto& [name, positions, normals, colors, uvs, triangles, edges, targets] = mesh;
    add_all(positions, normals, colors, triangles, edges, targets);
    if (asked_for_.contains(Channel::uv)) add_all(std::string_view("uvs"), uvs);
    // Earlier versions drew what has alpha as if it were opaque.
    if (has_alpha(mesh)) add(std::string_view("vertex alpha"));
  }
  void add(const Object& object) {
    const auto& [name, mesh, node, material, morph] = object;
    const auto& [base_color, shading, double_sided, line_width, own_name, alpha_mode, alpha_cutoff, base_color_track] =
        material;
    add_all(mesh, node, base_color, shading, double_sided, morph);
    if (line_width != 1) add_all(std::string_view("line_width"), line_width);
    if (alpha_mode != AlphaMode::blend) add_all(std::string_view("alpha_mode"), alpha_mode, alpha_cutoff);
    if (alpha_mode == AlphaMode::blend && base_color.a < 1) add(std::string_view("alpha"));
    if (!base_color_track.empty()) add_all(std::string_view("base_color_track"), base_color_track);
  }
  void add(const ImageSettings& image) {
    const auto& [width, height, channels, channel_names, compression, depth_format, background, samples, z_error,
                 p_error, n_error, visibility] = image;  // the last changes no pixel
    add_all(width, height, image.has_color(), image.has_depth(), std::string_view(compression), depth_format,
            background.has_value());
    if (background) add_all(background->top, background->bottom);
    // Only what differs from the default, and by name, so that files of earlier versions stay valid.
    if (samples != 1) add_all(std::string_view("samples"), samples);
    if (z_error != 0) add_all(std::string_view("z_error"), z_error);
    if (p_error != 0) add_all(std::string_view("p_error"), p_error);
    if (n_error != 0) add_all(std::string_view("n_error"), n_error);
    for (const Channel channel : channels - default_channels) add(name_of(channel));
    if (channel_names != ChannelNames::plain) add_all(std::string_view("channel_names"), channel_names);
  }
  void add(const Scene& scene) {
    const auto& [name, meshes, objects, timeline, image, accuracy_pixels, frames, parts, warnings, content_hash,
                 inputs] = scene;
    asked_for_ = image.channels;
    add_all(meshes, objects, timeline, image, accuracy_pixels, std::string_view(content_hash));
    add_names(scene);
  }

 private:
  // Those that channels show.
  void add_names(const Scene& scene) {
    if (asked_for_.contains(Channel::crypto_object))
      for (const Object& object : scene.objects) add(std::string_view(object.name));
    if (!(asked_for_ & ChannelSet{Channel::material_id, Channel::crypto_material}).empty())
      for (const Object& object : scene.objects) add(std::string_view(material_name(object)));
  }

  template <class Value>
  static constexpr bool packed =
      std::is_arithmetic_v<Value> || std::is_same_v<Value, glm::vec2> || std::is_same_v<Value, glm::vec3> ||
      std::is_same_v<Value, glm::vec4> || std::is_same_v<Value, glm::uvec2> || std::is_same_v<Value, glm::uvec3>;

  PixelHasher hasher_;
  ChannelSet asked_for_;
};

}  // namespace

std::string fingerprint(const Scene& scene) {
  SceneHasher hasher;
  hasher.add(std::string_view(version()));
  hasher.add(scene);
  return hasher.hex();
}

}  // namespace morphcl
