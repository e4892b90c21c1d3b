// The shapes of a scene's elastic objects, frame by frame.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "anim/elastic_body.hpp"
#include "host/render/frame/displaced_positions.hpp"
#include "morphcl/scene.hpp"

namespace morphcl {

// For one thread at a time. A body is made when its object is first asked for: until then it costs nothing.
class ElasticShapes {
 public:
  explicit ElasticShapes(const Scene& scene) : scene_(scene) {}  // which outlives this

  // A pure function of the object and the frame; the object is elastic. Error(bad_input): too many vertices, a motion
  // that overflows.
  std::shared_ptr<const DisplacedPositions> at(std::size_t object, std::int64_t frame);

 private:
  struct Body {
    std::unique_ptr<ElasticBody> body;
    std::vector<std::uint32_t> mass_of_vertex;
    std::int64_t frame = 0;
    std::shared_ptr<const DisplacedPositions> shape;  // at `frame`, or null
  };
  Body make_body(std::size_t object) const;

  const Scene& scene_;
  std::unordered_map<std::size_t, Body> bodies_;
  Displacements displacements_;
};

}  // namespace morphcl
