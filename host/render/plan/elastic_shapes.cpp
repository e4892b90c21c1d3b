#include "host/render/plan/elastic_shapes.hpp"

#include <xxhash.h>

#include <algorithm>
#include <utility>

#include "host/geometry/welded_mesh.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

double length_of(const Mesh& mesh, const WeldedMesh& welded, const glm::uvec2& edge) {
  const glm::dvec3 a = mesh.positions[welded.vertex_of_point[edge.x]],
                   b = mesh.positions[welded.vertex_of_point[edge.y]];
  return glm::length(b - a);
}

void add_edges(const Mesh& mesh, const WeldedMesh& welded, const Elastic& elastic, SpringNet& net) {
  // An edge without length is as stiff as one of this part of the mean.
  constexpr double min_part = 1e-3;
  double mean = 0;
  for (const glm::uvec2& edge : welded.edges)
    mean += length_of(mesh, welded, edge) / static_cast<double>(welded.edges.size());
  net.edges.reserve(welded.edges.size());
  for (const glm::uvec2& edge : welded.edges) {
    double stiffness = elastic.stiffness;
    if (elastic.rule == EdgeStiffness::by_length && mean > 0)
      stiffness *= mean / std::max(length_of(mesh, welded, edge), min_part * mean);
    if (stiffness > 0) net.edges.push_back({edge.x, edge.y, stiffness});
  }
}

SpringNet spring_net_of(const Mesh& mesh, const WeldedMesh& welded, const Elastic& elastic) {
  SpringNet net;
  net.masses = welded.vertex_of_point.size();
  net.anchor = elastic.anchor;
  net.damping = elastic.damping;
  net.stiffness_damping = elastic.edge_damping;
  add_edges(mesh, welded, elastic, net);
  return net;
}

MorphDrive drive_of(const Mesh& mesh, const WeldedMesh& welded, const MorphWeights& weights) {
  MorphDrive drive;
  drive.weights = weights;
  for (const MorphTarget& target : mesh.targets) {
    Displacements& displacements = drive.targets.emplace_back(welded.vertex_of_point.size(), glm::dvec3(0.0));
    if (target.positions.empty()) continue;
    for (std::size_t point = 0; point < displacements.size(); ++point) {
      const std::uint32_t vertex = welded.vertex_of_point[point];
      displacements[point] = target.positions[vertex];
      if (target.form == TargetForm::absolute) displacements[point] -= glm::dvec3(mesh.positions[vertex]);
    }
  }
  return drive;
}

}  // namespace

SpringNet spring_net_of(const Mesh& mesh, const Elastic& elastic) { return spring_net_of(mesh, weld(mesh), elastic); }

MorphDrive drive_of(const Mesh& mesh, const MorphWeights& weights) { return drive_of(mesh, weld(mesh), weights); }

ElasticShapes::Body ElasticShapes::make_body(std::size_t object) const {
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(scene_.objects[object].mesh)];
  const MorphWeights& weights = scene_.objects[object].morph;
  WeldedMesh welded = weld(mesh);
  Body body;
  body.body = make_elastic_body(spring_net_of(mesh, welded, *weights.elastic), weights.elastic->rest,
                                drive_of(mesh, welded, weights), scene_.timeline.time);
  body.mass_of_vertex = std::move(welded.point_of_vertex);
  return body;
}

std::shared_ptr<const DisplacedPositions> ElasticShapes::at(std::size_t object, std::int64_t frame) {
  auto found = bodies_.find(object);
  if (found == bodies_.end()) found = bodies_.emplace(object, make_body(object)).first;
  Body& body = found->second;
  if (body.shape && body.frame == frame) return body.shape;

  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(scene_.objects[object].mesh)];
  body.body->displacements_at(frame, displacements_);
  auto shape = std::make_shared<DisplacedPositions>();
  shape->positions.reserve(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const glm::dvec3 exact = glm::dvec3(mesh.positions[vertex]) + displacements_[body.mass_of_vertex[vertex]];
    shape->positions.emplace_back(to_fp32(exact.x), to_fp32(exact.y), to_fp32(exact.z));
  }
  const XXH128_hash_t hash = XXH3_128bits(shape->positions.data(), shape->positions.size() * sizeof(glm::vec3));
  shape->hash = {hash.low64, hash.high64};
  shape->box = box_of(shape->positions);
  shape->method = body.body->method();
  shape->masses = displacements_.size();
  body.frame = frame;
  body.shape = shape;
  return shape;
}

}  // namespace morphcl
