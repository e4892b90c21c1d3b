#include "host/render/plan/view_volume.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/render/frame/raster_grid.hpp"
#include "morphcl/error.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

void set_near_plane(float depth_factor, float w_factor, float constant, CameraConstants& camera) {
  camera.near_plane[0] = depth_factor;
  camera.near_plane[1] = w_factor;
  camera.near_plane[2] = constant;
}

// Returns the depth row of the matrix.
glm::dvec4 measure_depth(const Projection& projection, CameraConstants& camera) {
  const double near = near_distance(projection), far = far_distance(projection);
  if (camera.parallel) {
    camera.near_depth = to_fp32(-near);
    camera.far_depth = to_fp32(-far);
    set_near_plane(-1.0f, 0.0f, camera.near_depth, camera);
    camera.near_w = 1.0f;
    camera.near = 0.0f;
    return {0, 0, 1, 0};
  }
  camera.near = camera.near_w = to_fp32(near);
  if (!(camera.near_w >= 1e-30f)) throw Error(ErrorKind::bad_input, "", fmt::format("near = {} is below 1e-30", near));
  set_near_plane(0.0f, 1.0f, -camera.near_w, camera);
  camera.near_depth = 1.0f;
  camera.far_depth = std::isinf(far) ? 0.0f : to_fp32(near / far);
  return {0, 0, 0, camera.near_w};
}

}  // namespace

ViewVolume make_view_volume(const Projection& projection, int width, int height, double margin) {
  ViewVolume volume;
  volume.camera.parallel = is_parallel(projection);
  const glm::dvec4 depth_row = measure_depth(projection, volume.camera);
  volume.eye_to_ndc = projection_matrix(projection, static_cast<double>(width) / height);
  volume.eye_to_clip = volume.eye_to_ndc;
  for (int column = 0; column < 4; ++column) volume.eye_to_clip[column][2] = depth_row[column];

  // Clip coordinates carry no constant; w is 1 in parallel projections, and in perspective the constant is -near = -z.
  const glm::dvec4 near_plane =
      volume.camera.parallel ? glm::dvec4(0, 0, -1, volume.camera.near_depth) : glm::dvec4(0, 0, -1, 1);
  const glm::dvec4 far_plane(0, 0, 1, -volume.camera.far_depth);
  const double x = 1 + 2 * margin / width, y = 1 + 2 * margin / height;
  volume.view = {near_plane, far_plane, {1, 0, 0, x}, {-1, 0, 0, x}, {0, 1, 0, y}, {0, -1, 0, y}};
  const RasterGrid grid(width, height);
  volume.clip = {
      near_plane, {1, 0, 0, grid.guard_x}, {-1, 0, 0, grid.guard_x}, {0, 1, 0, grid.guard_y}, {0, -1, 0, grid.guard_y}};
  return volume;
}

}  // namespace morphcl
