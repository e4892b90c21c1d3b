#include <morphcl/collision.hpp>
#include <morphcl/solids.hpp>

bool use_collision() {
  const morphcl::MeshTree cube(morphcl::make_solid("cube"));
  return morphcl::collide(cube, cube).contact == morphcl::Contact::crossing && cube.closed() &&
         morphcl::place_in_mesh(cube, glm::dvec3(1e6)) == morphcl::PointPlace::outside;
}
