#include <morphcl/mesh.hpp>

bool use_mesh() {
  morphcl::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.push_back({0, 1, 2});
  morphcl::validate(mesh);
  return morphcl::wireframe_edges(mesh).size() == 3;
}
