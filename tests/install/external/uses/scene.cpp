#include <morphcl/scene.hpp>

bool use_scene() {
  morphcl::Scene scene;
  morphcl::Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  scene.add_object("point", mesh);
  morphcl::validate(scene);
  return morphcl::frame_numbers(morphcl::parse_frame_range("1-9x4")).size() == 3;
}
