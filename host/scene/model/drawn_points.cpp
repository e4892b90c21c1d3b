#include "host/scene/model/drawn_points.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "anim/timeline_at.hpp"
#include "host/scene/model/elastic_object.hpp"

namespace morphcl {

namespace {

constexpr std::size_t max_frames = 10'000, max_object_frames = 500'000, max_elastic_vertex_frames = 200'000;
constexpr std::size_t min_tree_samples = 4, min_tree_vertices = 256;  // from which on a tree pays
constexpr double infinity = std::numeric_limits<double>::infinity();

bool moves(const Scene& scene) {
  const Timeline& timeline = scene.timeline;
  const auto node_moves = [](const Node& node) { return moves_itself(node) || !node.visible_track.empty(); };
  const auto morphs = [](const Object& object) { return !object.morph.tracks.empty(); };
  return std::any_of(timeline.nodes.begin(), timeline.nodes.end(), node_moves) ||
         std::any_of(scene.objects.begin(), scene.objects.end(), morphs);
}

// The frames that are looked at.
std::vector<std::int64_t> sample_frames(const Scene& scene) {
  const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  if (!moves(scene)) return {frames.front()};
  const std::size_t affordable = max_object_frames / std::max<std::size_t>(scene.objects.size(), 1);
  const std::size_t samples = std::min(frames.size(), std::clamp<std::size_t>(affordable, 2, max_frames));
  std::vector<std::int64_t> chosen;
  for (std::size_t i = 0; i < samples; ++i)
    chosen.push_back(frames[samples == 1 ? 0 : i * (frames.size() - 1) / (samples - 1)]);
  return chosen;
}

glm::dvec3 placed(const glm::dmat4x3& to_eye_axes, const glm::dvec3& point) {
  return to_eye_axes * glm::dvec4(point, 1.0);
}

}  // namespace

// An object while the frames are gone through.
struct DrawnPoints::Seen {
  Vertices* vertices;
  ElasticObject elastic;
  std::optional<std::size_t> sample;  // the latest
};

DrawnPoints::Vertices& DrawnPoints::vertices_of(const Scene& scene, const Object& object) {
  const bool lines = object.material.shading == Shading::wireframe;
  const auto [found, is_new] = vertices_.try_emplace({object.mesh, lines});
  if (is_new) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    found->second.mesh = &mesh;
    found->second.drawn = drawn_vertices(mesh, lines);
  }
  return found->second;
}

void DrawnPoints::add(const glm::dmat4x3& to_eye_axes, const std::vector<double>& weights, Seen& seen) {
  if (seen.sample) {
    const Sample& last = samples_[*seen.sample];
    const auto last_weights = weights_.begin() + static_cast<std::ptrdiff_t>(last.first_weight);
    if (last.to_eye_axes == to_eye_axes && std::equal(weights.begin(), weights.end(), last_weights)) return;
  }
  seen.sample = samples_.size();
  samples_.push_back({seen.vertices, weights_.size(), weights.size(), to_eye_axes});
  weights_.insert(weights_.end(), weights.begin(), weights.end());
  ++seen.vertices->samples;
}

DrawnPoints::DrawnPoints(const Scene& scene, const glm::dmat3& to_eye_axes) {
  const std::vector<std::int64_t> frames = sample_frames(scene);
  const TimeBase& time = scene.timeline.time;
  std::vector<Seen> objects;
  for (const Object& object : scene.objects) {
    Seen& seen = objects.emplace_back(Seen{&vertices_of(scene, object), {}, {}});
    const Mesh& mesh = *seen.vertices->mesh;
    if (object.morph.elastic && mesh.positions.size() * frames.size() <= max_elastic_vertex_frames)
      seen.elastic = make_elastic_object(mesh, object.morph, time);
  }
  Displacements displacements;
  std::vector<double> weights;
  for (const std::int64_t frame : frames) {
    const FrameState state = evaluate(scene.timeline, frame);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const auto node = static_cast<std::size_t>(scene.objects[i].node);
      const Vertices& vertices = *objects[i].vertices;
      if (!state.node_visible[node] || vertices.drawn.empty()) continue;
      const glm::dmat4x3 placing(glm::dmat4(to_eye_axes) * state.node_to_world[node]);
      if (objects[i].elastic.body) {
        objects[i].elastic.body->displacements_at(frame, displacements);
        for (const std::uint32_t vertex : vertices.drawn)
          points_.push_back(placed(placing, glm::dvec3(vertices.mesh->positions[vertex]) +
                                                displacements[objects[i].elastic.mass_of_vertex[vertex]]));
      } else {
        evaluate_weights(scene.objects[i].morph, tick_of(time, frame), weights);
        add(placing, weights, objects[i]);
      }
    }
  }
  for (auto& [key, vertices] : vertices_)
    if (vertices.samples >= min_tree_samples && vertices.drawn.size() >= min_tree_vertices)
      vertices.tree.emplace(*vertices.mesh, vertices.drawn);
}

std::optional<FarthestVertex> DrawnPoints::farthest_of(const Sample& sample, const glm::dvec3& direction,
                                                       double beyond) const {
  const std::span<const double> weights = std::span(weights_).subspan(sample.first_weight, sample.weight_count);
  const Vertices& vertices = *sample.vertices;
  if (vertices.tree) return vertices.tree->farthest(weights, direction, beyond);
  std::optional<FarthestVertex> best;
  for (const std::uint32_t vertex : vertices.drawn) {
    const double distance = glm::dot(morphed_vertex(*vertices.mesh, weights, vertex), direction);
    if (!(distance > (best ? best->distance : beyond) && distance < infinity)) continue;
    best = {distance, vertex};
  }
  return best;
}

glm::dvec3 DrawnPoints::farthest(const glm::dvec3& direction) const {
  double reach = -infinity;
  const Sample* farthest_sample = nullptr;
  std::uint32_t farthest_vertex = 0;
  for (const Sample& sample : samples_) {
    const glm::dvec3 in_object = direction * glm::dmat3(sample.to_eye_axes);
    const double origin = glm::dot(sample.to_eye_axes[3], direction);
    const auto found = farthest_of(sample, in_object, reach - origin);
    if (!found) continue;
    reach = found->distance + origin;
    farthest_sample = &sample;
    farthest_vertex = found->vertex;
  }
  glm::dvec3 result(0.0);
  if (farthest_sample) {
    const std::span<const double> weights =
        std::span(weights_).subspan(farthest_sample->first_weight, farthest_sample->weight_count);
    result = placed(farthest_sample->to_eye_axes,
                    morphed_vertex(*farthest_sample->vertices->mesh, weights, farthest_vertex));
  }
  for (const glm::dvec3& point : points_) {
    const double distance = glm::dot(point, direction);
    if (!(distance > reach && distance < infinity)) continue;
    reach = distance;
    result = point;
  }
  return result;
}

}  // namespace morphcl
