#include "anim/elastic.hpp"

#include <cmath>

namespace morphcl {

Spring anchor_spring(const Elastic& elastic) {
  const double omega = std::sqrt(elastic.anchor);
  return {omega, 0.5 * (elastic.damping / omega + elastic.edge_damping * omega)};
}

}  // namespace morphcl
