#include "host/scene/gltf/gltf_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "host/scene/model/model_choice.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

class AnimationReader {
 public:
  AnimationReader(const GltfDocument& document, const GltfAccessors& accessors, const TimeBase& time,
                  const std::vector<std::size_t>& node_targets, GltfNodes& nodes, GltfWarnings& warnings)
      : document_(document),
        accessors_(accessors),
        time_(time),
        node_targets_(node_targets),
        nodes_(nodes),
        warnings_(warnings) {
    result_.node_weights.resize(nodes.nodes.size());
  }

  void read(const GltfValue& animation) {
    const GltfValue samplers = animation.get("samplers"), channels = animation.get("channels");
    for (std::size_t i = 0; i < channels.size(); ++i) read_channel(channels[i], samplers);
  }

  GltfAnimations result() {
    if (driven_again_ > 0)
      warnings_.say(fmt::format("values driven by several animation channels: {}; the first channel of each is used",
                                driven_again_));
    return std::move(result_);
  }

 private:
  void read_channel(const GltfValue& channel, const GltfValue& samplers) {
    const int sampler = channel.get("sampler").index(samplers.size(), "samplers");
    const GltfValue target = channel.get("target");
    const int node = target.index("node", nodes_.nodes.size(), "nodes");
    const GltfValue target_path = target.get("path");
    const std::string& path = target_path.text();
    if (node < 0) {
      if (path == "pointer") warnings_.not_drawn("extension KHR_animation_pointer");
      return;  // the specification: ignore a channel without a node
    }
    const auto place = destination(target, static_cast<std::size_t>(node), path);
    if (!place.track) return;
    if (!place.track->empty()) {
      ++driven_again_;
      return;
    }
    GltfSampler keys = read_sampler(samplers[static_cast<std::size_t>(sampler)], document_, accessors_, time_,
                                    {place.width, path == "rotation", path == "weights"}, warnings_);
    result_.duration_seconds = std::max(result_.duration_seconds, keys.last_seconds);
    if (path == "weights") result_.node_weights[static_cast<std::size_t>(node)].bytes = keys.bytes;
    *place.track = std::move(keys.track);
  }

  struct Destination {
    Track* track = nullptr;  // null: not drawn
    std::size_t width = 0;
  };

  Destination destination(const GltfValue& target, std::size_t node, const std::string& path) {
    Node& moved = nodes_.nodes[node];
    if (path == "weights") {
      if (node_targets_[node] == 0) target.fail(fmt::format("nodes[{}] has no morph targets to weigh", node));
      return {&result_.node_weights[node].track, node_targets_[node]};
    }
    if (path != "translation" && path != "rotation" && path != "scale") {
      warnings_.say(fmt::format("{}: path '{}' is not animated", target.place(), path.substr(0, 60)));
      return {};
    }
    if (nodes_.has_matrix[node])
      target.fail(fmt::format("nodes[{}] has a matrix; only translation, rotation and scale can be animated", node));
    if (path == "translation") return {&moved.translation_track, 3};
    if (path == "rotation") return {&moved.rotation_track, 4};
    return {&moved.scale_track, 3};
  }

  const GltfDocument& document_;
  const GltfAccessors& accessors_;
  const TimeBase& time_;
  const std::vector<std::size_t>& node_targets_;
  GltfNodes& nodes_;
  GltfWarnings& warnings_;
  GltfAnimations result_;
  std::size_t driven_again_ = 0;
};

std::vector<ModelPart> list_animations(const GltfDocument& document, const GltfAccessors& accessors,
                                       GltfWarnings& warnings) {
  std::vector<ModelPart> parts;
  std::map<int, double> last_keys;  // of the accessors that hold times
  for (std::size_t i = 0; i < document.count("animations"); ++i) {
    const GltfValue animation = document.element("animations", i);
    ModelPart part{document.path(), ModelPart::Kind::animation, static_cast<int>(i), warnings.read_name(animation, "")};
    try {
      const GltfValue samplers = animation.get("samplers");
      for (std::size_t s = 0; s < samplers.size(); ++s) {
        const int input = samplers[s].get("input").index(accessors.size(), "accessors");
        if (!last_keys.contains(input)) last_keys[input] = accessors.decode<double>(input).back();
        part.seconds = std::max(part.seconds, last_keys[input]);
      }
    } catch (const Error&) {
      part.seconds = 0;  // what is wrong is said when it is played
    }
    document.budget().charge(1, sizeof part + part.name.size() + part.model.size(), animation.place());
    parts.push_back(std::move(part));
  }
  return parts;
}

// Whether two animations move the same value of a node.
bool animations_collide(const GltfDocument& document) {
  std::map<std::pair<std::uint64_t, std::string>, std::size_t> movers;
  for (std::size_t i = 0; i < document.count("animations"); ++i) {
    const GltfValue channels = document.element("animations", i).get("channels");
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const GltfValue target = channels[c].get("target");
      if (!target.find("node")) continue;
      const auto [mover, is_new] =
          movers.try_emplace({target.get("node").integer(), target.get("path").text().substr(0, 20)}, i);
      if (!is_new && mover->second != i) return true;
    }
  }
  return false;
}

}  // namespace

GltfAnimations read_animations(const GltfDocument& document, const GltfAccessors& accessors, const TimeBase& time,
                               const std::vector<std::size_t>& node_targets, const std::optional<std::string>& wanted,
                               GltfNodes& nodes, std::vector<ModelPart>& parts, GltfWarnings& warnings) {
  std::vector<ModelPart> animations = list_animations(document, accessors, warnings);
  std::vector<std::string> names;
  for (const ModelPart& animation : animations) names.push_back(animation.name);
  if (wanted) {
    animations[choose(names, *wanted, "animation", document.path())].used = true;
  } else if (!animations.empty() && animations_collide(document)) {
    animations[0].used = true;
    warnings.say(
        fmt::format("{}: several animations move the same, and the first is played; --animation, or animation "
                    "in a shot's object, chooses another: {}",
                    document.path(), numbered(names)));
  } else {
    for (ModelPart& animation : animations) animation.used = true;
  }
  AnimationReader reader(document, accessors, time, node_targets, nodes, warnings);
  for (std::size_t i = 0; i < animations.size(); ++i)
    if (animations[i].used) reader.read(document.element("animations", i));
  parts.insert(parts.end(), animations.begin(), animations.end());
  return reader.result();
}

}  // namespace morphcl
