// What a scene's camera shows, in words and numbers.
#pragma once

#include <string>

#include "morphcl/scene.hpp"

namespace morphcl::cli {

// At the first frame: "isometric" and its kin are orthographic here, as they are drawn.
struct CameraInfo {
  std::string projection;        // "perspective, 45 degrees high"
  std::string window;            // what shows, and which axis was widened or cropped
  std::string vanishing_points;  // "2: x at NDC (-1, 0), pixel (0, 540); z at ..."
};
CameraInfo describe_camera(const Scene& scene);

}  // namespace morphcl::cli
