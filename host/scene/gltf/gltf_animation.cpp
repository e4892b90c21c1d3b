#include "host/scene/gltf/gltf_animation.hpp"

#include <fmt/format.h>

#include <algorithm>

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
                                    {place.width, path == "rotation", path == "weights"});
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

}  // namespace

GltfAnimations read_animations(const GltfDocument& document, const GltfAccessors& accessors, const TimeBase& time,
                               const std::vector<std::size_t>& node_targets, GltfNodes& nodes, GltfWarnings& warnings) {
  AnimationReader reader(document, accessors, time, node_targets, nodes, warnings);
  for (std::size_t i = 0; i < document.count("animations"); ++i) reader.read(document.element("animations", i));
  return reader.result();
}

}  // namespace morphcl
