// The camera of a frame in high precision: what goes to clip space, and back from a pixel.
//
// Everything follows from the frame's world -> eye matrix and the projection's matrix, as they are in fp64; nothing is
// rounded to fp32. Distances are positive along the view axis.
#pragma once

#include "host/render/frame/raster_grid.hpp"
#include "lab/frame_error/real_vector.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl::accuracy {

template <class Real>
struct PreciseCamera {
  int width, height;  // pixels
  bool parallel;
  Real near, far;
  Matrix<Real> world_to_eye, eye_to_clip;  // of clip space, rows x, y and w are used
  Real guard_x, guard_y;  // triangles are cut where |x| exceeds guard_x * w, as the sub-pixel grid wants it

  PreciseCamera(const CameraState& camera, int image_width, int image_height)
      : width(image_width),
        height(image_height),
        parallel(is_parallel(camera.projection)),
        near(near_distance(camera.projection)),
        far(far_distance(camera.projection)),
        world_to_eye(to_real<Real>(camera.world_to_eye)),
        eye_to_clip(
            to_real<Real>(projection_matrix(camera.projection, static_cast<double>(image_width) / image_height))) {
    const RasterGrid grid(width, height);
    guard_x = Real(grid.guard_x);
    guard_y = Real(grid.guard_y);
  }

  // The point of eye space at `distance` that shows at the centre of pixel (px, py).
  Vector3<Real> position(int px, int py, const Real& distance) const {
    const Real z = -distance, w = eye_to_clip[3][2] * z + eye_to_clip[3][3];
    const Real x_ndc = Real(2 * px + 1) / width - 1, y_ndc = 1 - Real(2 * py + 1) / height;
    const auto constant = [&](int row) -> Real { return eye_to_clip[row][2] * z + eye_to_clip[row][3]; };
    return solve(x_ndc * w - constant(0), y_ndc * w - constant(1), z);
  }

  // Whether a surface with this normal at this point of eye space turns its outside to the viewer, or is seen edge-on.
  bool is_seen_from_outside(const Vector3<Real>& normal, const Vector3<Real>& point) const {
    return dot(normal, parallel ? solve(eye_to_clip[0][2], eye_to_clip[1][2], Real(-1)) : point) <= 0;
  }

 private:
  // (x, y, z) where rows 0 and 1 of eye_to_clip, of x and y alone, give these values.
  Vector3<Real> solve(const Real& first, const Real& second, const Real& z) const {
    const Row<Real>&a = eye_to_clip[0], &b = eye_to_clip[1];
    const Real determinant = a[0] * b[1] - a[1] * b[0];
    return {(first * b[1] - second * a[1]) / determinant, (a[0] * second - b[0] * first) / determinant, z};
  }
};

}  // namespace morphcl::accuracy
