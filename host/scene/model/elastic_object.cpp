#include "host/scene/model/elastic_object.hpp"

#include <algorithm>
#include <utility>

#include "host/geometry/welded_mesh.hpp"

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

ElasticObject make_elastic_object(const Mesh& mesh, const MorphWeights& weights, const TimeBase& time) {
  WeldedMesh welded = weld(mesh);
  auto body = make_elastic_body(spring_net_of(mesh, welded, *weights.elastic), weights.elastic->rest,
                                drive_of(mesh, welded, weights), time);
  return {std::move(body), std::move(welded.point_of_vertex)};
}

}  // namespace morphcl
