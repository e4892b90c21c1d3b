#include <cstdio>
#include <morphcl/collision.hpp>
#include <morphcl/solids.hpp>

int main() {
  const morphcl::MeshTree cube(morphcl::make_solid("cube")), sphere(morphcl::make_solid("sphere"));
  const morphcl::Collision collision = morphcl::collide(cube, sphere);
  std::printf("%s, %zu pairs of triangles\n", collision.collides() ? "they meet" : "they are apart", collision.count);
  if (collision.pairs.empty()) return 0;
  const glm::dvec3 at = collision.pairs.front().points.front();
  std::printf("first at (%g, %g, %g)\n", at.x, at.y, at.z);
}
