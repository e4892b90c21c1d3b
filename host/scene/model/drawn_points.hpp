// Everything that a scene draws, at all its frames, as the points that reach farthest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "host/geometry/morph_tree.hpp"
#include "morphcl/scene.hpp"

namespace morphcl {

// Where a camera of these axes sees the drawn vertices: in the axes of the eye, the origin the world's.
//
// Every drawn vertex counts, where it is at each frame: morphed, moved by its node, carried by springs. An object that
// stands still counts once, and where a mesh is met often a search reads little of it (MorphTree): the 14 searches or
// so of a fitted camera take 0.2 s among a million vertices that turn and morph for 100 frames.
//
// Bounded, so that what is beyond may be missed: frames are 10,000 at most, objects times frames 500,000 (some 60 MB),
// evenly spread, the first and the last among them; an elastic object of more than 200,000 vertices times frames
// counts where its weights ask for it.
class DrawnPoints {
 public:
  // The scene outlives this. Errors as evaluate() has them.
  DrawnPoints(const Scene& scene, const glm::dmat3& to_eye_axes);

  bool empty() const { return samples_.empty() && points_.empty(); }
  // Not where it is empty.
  glm::dvec3 farthest(const glm::dvec3& direction) const;

 private:
  // The vertices of a mesh that are drawn.
  struct Vertices {
    const Mesh* mesh = nullptr;
    std::vector<std::uint32_t> drawn;
    std::size_t samples = 0;
    std::optional<MorphTree> tree;  // where it pays
  };
  // An object at a frame.
  struct Sample {
    const Vertices* vertices;
    std::size_t first_weight, weight_count;
    glm::dmat4x3 to_eye_axes;
  };

  struct Seen;

  Vertices& vertices_of(const Scene& scene, const Object& object);
  void add(const glm::dmat4x3& to_eye_axes, const std::vector<double>& weights, Seen& seen);
  std::optional<FarthestVertex> farthest_of(const Sample& sample, const glm::dvec3& direction, double beyond) const;

  std::map<std::pair<int, bool>, Vertices> vertices_;  // of a mesh, as faces or as lines
  std::vector<Sample> samples_;
  std::vector<double> weights_;
  std::vector<glm::dvec3> points_;  // of elastic objects
};

}  // namespace morphcl
