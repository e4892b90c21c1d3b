#include <morphcl/predicates.hpp>

bool use_predicates() { return morphcl::orientation(glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)) == 1; }
