#include "host/render/plan/elastic_shapes.hpp"

#include <xxhash.h>

#include <utility>

#include "host/scene/model/elastic_object.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

ElasticShapes::Body ElasticShapes::make_body(std::size_t object) const {
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(scene_.objects[object].mesh)];
  ElasticObject made = make_elastic_object(mesh, scene_.objects[object].morph, scene_.timeline.time);
  Body body;
  body.body = std::move(made.body);
  body.mass_of_vertex = std::move(made.mass_of_vertex);
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
