// An elastic object's mesh as masses and springs.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "anim/elastic_body.hpp"
#include "anim/morph_drive.hpp"
#include "anim/spring_net.hpp"
#include "morphcl/mesh.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

// The masses and edges of an object's mesh, and where its weights drive them.
SpringNet spring_net_of(const Mesh& mesh, const Elastic& elastic);
MorphDrive drive_of(const Mesh& mesh, const MorphWeights& weights);

struct ElasticObject {
  std::unique_ptr<ElasticBody> body;
  std::vector<std::uint32_t> mass_of_vertex;
};

// `weights` are elastic. Error(bad_input): too many vertices.
ElasticObject make_elastic_object(const Mesh& mesh, const MorphWeights& weights, const TimeBase& time);

}  // namespace morphcl
