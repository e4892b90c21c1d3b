#include "anim/spring_net.hpp"

namespace morphcl {

void add_stiffness(const SpringNet& net, const Displacements& x, double factor, Displacements& sum) {
  for (std::size_t i = 0; i < net.masses; ++i) sum[i] += factor * net.anchor * x[i];
  for (const SpringNet::Edge& edge : net.edges) {
    const glm::dvec3 force = factor * edge.stiffness * (x[edge.a] - x[edge.b]);
    sum[edge.a] += force;
    sum[edge.b] -= force;
  }
}

double energy(const SpringNet& net, const Displacements& x, const Displacements& velocity, const Displacements& rest) {
  double twice = 0;
  for (std::size_t i = 0; i < net.masses; ++i) {
    const glm::dvec3 strain = x[i] - rest[i];
    twice += glm::dot(velocity[i], velocity[i]) + net.anchor * glm::dot(strain, strain);
  }
  for (const SpringNet::Edge& edge : net.edges) {
    const glm::dvec3 strain = (x[edge.a] - rest[edge.a]) - (x[edge.b] - rest[edge.b]);
    twice += edge.stiffness * glm::dot(strain, strain);
  }
  return 0.5 * twice;
}

}  // namespace morphcl
