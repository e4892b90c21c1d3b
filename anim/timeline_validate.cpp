#include <fmt/core.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "anim/hierarchy.hpp"
#include "host/math/finite.hpp"
#include "morphcl/error.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

namespace {

void require(bool holds, const std::string& place, const std::string& message) {
  if (!holds) throw Error(ErrorKind::bad_input, place, message);
}

void check_track(const Track& track, int width, bool rotation, const std::string& place, const char* name) {
  if (track.empty()) return;
  require(track.width() == width, place,
          fmt::format("the {} track has {} components; it needs {}", name, track.width(), width));
  require(track.is_rotation() == rotation, place,
          fmt::format("the {} track must {}be a rotation track", name, rotation ? "" : "not "));
}

template <typename Value>
void check_finite(const Value& value, const std::string& place, const char* name) {
  require(is_finite(value), place, fmt::format("{} is NaN or infinite; it must be finite", name));
}

void check_time(const TimeBase& time) {
  const auto in_range = [](std::int64_t n) { return n > 0 && n <= 1'000'000; };
  require(in_range(time.fps_numerator) && in_range(time.fps_denominator), "frames",
          fmt::format("a frame rate of {}/{} is out of range; both numbers must be 1 to 1000000", time.fps_numerator,
                      time.fps_denominator));
}

void check_node(const Node& node, std::size_t index) {
  const std::string place = fmt::format("nodes[{}] {}", index, node.name);
  check_finite(node.static_transform, place, "static_transform");
  const glm::dmat4& m = node.static_transform;
  require(m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1, place,
          "static_transform is not affine; its last row must be 0 0 0 1");
  check_finite(node.translation, place, "translation");
  const glm::dvec4 rotation(node.rotation.x, node.rotation.y, node.rotation.z, node.rotation.w);
  check_finite(rotation, place, "rotation");
  require(rotation != glm::dvec4(0), place, "rotation is 0 0 0 0; a rotation is a quaternion of length 1");
  check_finite(node.scale, place, "scale");
  check_track(node.translation_track, 3, false, place, "translation");
  check_track(node.rotation_track, 4, true, place, "rotation");
  check_track(node.scale_track, 3, false, place, "scale");
  check_track(node.visible_track, 1, false, place, "visible");
}

void check_elastic(const Elastic& elastic, const std::string& place) {
  const auto check = [&place](const char* name, double value, double min, double max) {
    require(value >= min && value <= max, place,
            fmt::format("elastic: {} is {}; it must be {} to {}", name, value, min, max));
  };
  check("anchor", elastic.anchor, min_elastic_anchor, max_elastic_stiffness);
  check("stiffness", elastic.stiffness, 0, max_elastic_stiffness);
  check("damping", elastic.damping, 0, max_elastic_damping);
  check("edge_damping", elastic.edge_damping, 0, max_elastic_edge_damping);
}

void check_weights(const MorphWeights& morph) {
  const std::string place = "weights";
  const std::size_t targets = morph.weights.size();
  for (std::size_t i = 0; i < targets; ++i)
    require(std::isfinite(morph.weights[i]), place, fmt::format("weight {} is NaN or infinite; it must be finite", i));
  for (const WeightTrack& driven : morph.tracks) {
    if (driven.track.empty()) continue;
    const int first = driven.first_target, width = driven.track.width();
    const bool fits = first >= 0 && static_cast<std::size_t>(first) <= targets &&
                      static_cast<std::size_t>(width) <= targets - static_cast<std::size_t>(first);
    require(fits, place,
            fmt::format("a track of {} components from target {} on drives targets that do not exist; the "
                        "mesh has {}",
                        width, first, targets));
    require(!driven.track.is_rotation(), place, "a weight track must not be a rotation track");
  }
  if (morph.elastic) check_elastic(*morph.elastic, place);
}

// What tracks replace is judged frame by frame.
void check_projection(const Camera& camera, const std::string& place) {
  const bool is_animated = !(camera.fovy_track.empty() && camera.fovx_track.empty() && camera.near_track.empty() &&
                             camera.far_track.empty());
  if (is_animated) return;
  try {
    validate(camera.projection);
  } catch (const Error& error) {
    require(false, place, error.message());
  }
}

void check_index(int node, std::size_t nodes, const std::string& place) {
  require(node >= -1 && (node == -1 || static_cast<std::size_t>(node) < nodes), place,
          fmt::format("node {} does not exist; there are {} nodes", node, nodes));
}

void check_camera(const Camera& camera, std::size_t nodes) {
  const std::string place = "camera";
  check_index(camera.node, nodes, place);
  check_index(camera.parent, nodes, place);
  require(camera.node < 0 || camera.parent < 0, place, "it has a node and a parent; one of them says where it stands");
  check_finite(camera.eye, place, "eye");
  check_finite(camera.target, place, "target");
  check_finite(camera.up, place, "up");
  check_track(camera.eye_track, 3, false, place, "eye");
  check_track(camera.target_track, 3, false, place, "target");
  check_track(camera.up_track, 3, false, place, "up");
  check_track(camera.fovy_track, 1, false, place, "fovy");
  check_track(camera.fovx_track, 1, false, place, "fovx");
  check_track(camera.near_track, 1, false, place, "near");
  check_track(camera.far_track, 1, false, place, "far");
  require(camera.fovy_track.empty() || std::holds_alternative<Perspective>(camera.projection), place,
          "a fovy track needs a projection with a vertical field of view: perspective");
  require(camera.fovx_track.empty() || std::holds_alternative<HorizontalPerspective>(camera.projection), place,
          "a fovx track needs a projection with a horizontal field of view: perspective");
  check_projection(camera, place);
}

void check_light(const Light& light, std::size_t index, std::size_t nodes) {
  const std::string place = fmt::format("lights[{}]", index);
  check_index(light.node, nodes, place);
  check_finite(light.vector, place, "vector");
  check_finite(light.color, place, "color");
  check_track(light.vector_track, 3, false, place, "vector");
  check_track(light.color_track, 3, false, place, "color");
  if (!light.spot) return;
  require(light.kind == LightKind::point, place, "a spot light has a position; its kind is point");
  check_finite(light.spot->target, place, "target");
  check_track(light.spot->target_track, 3, false, place, "target");
  const double inner = light.spot->inner_cone_degrees, outer = light.spot->outer_cone_degrees;
  require(inner >= 0 && outer >= inner + min_cone_edge_degrees && outer <= 90, place,
          fmt::format("its cones are {} and {} degrees; 0 <= inner, inner + {} <= outer <= 90 is needed", inner, outer,
                      min_cone_edge_degrees));
}

}  // namespace

void validate(const MorphWeights& morph) { check_weights(morph); }

void validate(const Timeline& timeline) {
  check_time(timeline.time);
  for (std::size_t i = 0; i < timeline.nodes.size(); ++i) check_node(timeline.nodes[i], i);
  parents_first(timeline.nodes);
  check_camera(timeline.camera, timeline.nodes.size());
  for (std::size_t i = 0; i < timeline.lights.size(); ++i) check_light(timeline.lights[i], i, timeline.nodes.size());
  check_finite(timeline.ambient, "ambient", "ambient");
}

}  // namespace morphcl
