// How the vertices of an object follow its morph when they are masses on springs instead of points on rails.
//
// Every vertex is a mass of 1, tied to where the morph wants it (its anchor) and to its neighbours along the edges of
// the mesh: with d(t) the displacement from the base mesh that the weights ask for and y the one it has,
//   y'' + D y' + K_edges (y - r) + anchor (y - d) = 0,   D = damping + edge_damping K,   K = anchor + K_edges.
#pragma once

#include "anim/spring.hpp"

namespace morphcl {

// What the edges keep, r above.
enum class EdgeRest {
  driven,  // the shape that the morph has now: the object arrives at its targets
  base     // the base mesh: the object resists, and comes the nearer to its targets the weaker the edges are
};

enum class EdgeStiffness {
  equal,     // the same for every edge
  by_length  // as for rods of one material: in inverse proportion to the length, `stiffness` at the mean length
};

struct Elastic {
  double anchor = 400;      // 1/s^2: a vertex alone swings with sqrt(anchor) / (2 pi) Hz
  double stiffness = 4000;  // 1/s^2, of an edge
  double damping = 4;       // 1/s, of the velocity
  double edge_damping = 0;  // s, of the stiffness: damps what is stiff more
  EdgeRest rest = EdgeRest::driven;
  EdgeStiffness rule = EdgeStiffness::equal;
};

// How a vertex swings that moves as its neighbours do: the slowest spring of the object.
Spring anchor_spring(const Elastic& elastic);

// What a shot may ask for. Stiffness may be 0: then every vertex swings alone.
constexpr double min_elastic_anchor = 1e-6, max_elastic_stiffness = 1e16;  // 1/s^2
constexpr double max_elastic_damping = 1e8, max_elastic_edge_damping = 1;  // 1/s, s

}  // namespace morphcl
