#include <morphcl/camera.hpp>

bool use_camera() { return morphcl::look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}).world_to_eye[3].z == -5; }
