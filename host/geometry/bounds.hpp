// Bounds of meshes: axis-aligned boxes and spheres, also of a mesh under any morph weights without touching its
// vertices.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "morphcl/geometry.hpp"
#include "morphcl/mesh.hpp"

namespace morphcl {

Box intersection(const Box& a, const Box& b);
Box box_of(const std::vector<glm::vec3>& points);
// Contains the image of every point of `box` under the affine `matrix`; empty for an empty box.
Box transformed(const Box& box, const glm::dmat4& matrix);

// Around the box: its centre, half its diagonal. A box that is not empty.
Sphere sphere_of(const Box& box);

struct Interval {
  double lower = 0, upper = 0;
};

// What is known about a mesh's bounds once its vertices were read: O(vertices x targets) to build, O(targets) to use.
class MorphBounds {
 public:
  explicit MorphBounds(const Mesh& mesh);

  const Box& base() const { return base_; }

  // Contains every vertex of the mesh morphed by these weights (one a target), as computed in fp32 by any renderer.
  Box at(const std::vector<double>& weights) const;

  // The same for every choice of weights within the intervals.
  //
  // Method: interval arithmetic on both readings of the morph, base + sum w (target - base) and (1 - sum w) base + sum
  // w target; each contains the mesh, so their intersection does. The result is widened by the rounding of the
  // renderer's sum of n + 1 products: (n + 2) ulp of the largest sum of magnitudes.
  Box at(const std::vector<Interval>& weights) const;

  // Bounds the magnitudes that a morphed vertex relative to `pivot` adds up: |base - pivot| and for every target
  // |weight| times its delta, or if it is absolute that of its position and the base's, both relative to the pivot.
  glm::dvec3 terms(const std::vector<double>& weights, const glm::dvec3& pivot) const;

 private:
  struct Target {
    Box positions, deltas;
    bool absolute = false;
  };
  template <class IntervalOf>
  Box at_intervals(std::size_t count, IntervalOf interval_of) const;
  Box base_;
  std::vector<Target> targets_;
};

}  // namespace morphcl
