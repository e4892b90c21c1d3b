// Masses that are tied to anchors and, by springs, to each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace morphcl {

// Each mass is 1. Stiffness per mass, 1/s^2. K = anchor I + sum of k (e_a - e_b)(e_a - e_b)^T over the edges.
struct SpringNet {
  struct Edge {
    std::uint32_t a, b;  // different masses
    double stiffness;    // >= 0
  };
  std::size_t masses = 0;
  double anchor = 1;  // > 0
  std::vector<Edge> edges;
  double damping = 0, stiffness_damping = 0;  // D = damping I + stiffness_damping K, 1/s and s; >= 0
};

using Displacements = std::vector<glm::dvec3>;  // of each mass

// Adds factor K x to `sum`, edge by edge as factor k (x_a - x_b): however much stiffer one edge is than another, a
// uniform motion strains none. (In an assembled matrix a stiff edge's k rounds its neighbours' away.)
void add_stiffness(const SpringNet& net, const Displacements& x, double factor, Displacements& sum);

// Kinetic energy and that of the springs when their rest is at displacement `rest`.
double energy(const SpringNet& net, const Displacements& x, const Displacements& velocity, const Displacements& rest);

}  // namespace morphcl
