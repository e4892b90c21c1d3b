#include "cli/camera_info.hpp"

#include <fmt/core.h>

#include "morphcl/projection.hpp"

namespace morphcl::cli {

namespace {

struct Namer {
  std::string operator()(const Perspective& p) const {
    return fmt::format("perspective, {:.6g} degrees high", p.fovy_degrees);
  }
  std::string operator()(const HorizontalPerspective& p) const {
    return fmt::format("perspective, {:.6g} degrees wide", p.fovx_degrees);
  }
  std::string operator()(const Frustum&) const { return "frustum"; }
  std::string operator()(const CentralProjection& p) const {
    return fmt::format("central, the board {:.6g} before the eye", p.board);
  }
  std::string operator()(const Orthographic&) const { return "orthographic"; }
  std::string operator()(const Oblique& p) const {
    return fmt::format("oblique, 1 to the back is drawn ({:.6g}, {:.6g}) away", p.shear.x, p.shear.y);
  }
};

std::string window_text(const Projection& projection, double aspect) {
  const FittedWindow shown = fitted_window(projection, aspect);
  const Window& w = shown.window;
  const bool by_angle =
      std::holds_alternative<Perspective>(projection) || std::holds_alternative<HorizontalPerspective>(projection);
  std::string text = fmt::format("{:.6g} to {:.6g} across, {:.6g} to {:.6g} up{}", w.left, w.right, w.bottom, w.top,
                                 by_angle ? ", at distance 1" : "");
  if (shown.changed == ChangedAxis::none) return text;
  const bool along_x = shown.changed == ChangedAxis::x;
  const bool widened = std::visit(
      [&](const auto& p) {
        if constexpr (requires { p.left; })
          return along_x ? w.right - w.left > p.right - p.left : w.top - w.bottom > p.top - p.bottom;
        return false;
      },
      projection);
  return text + fmt::format("; {} along {} to fit the image", widened ? "widened" : "cropped", along_x ? "x" : "y");
}

std::string vanishing_text(const VanishingPoints& points, int width, int height) {
  std::string text = std::to_string(count(points));
  const Viewport viewport{0, 0, 1.0 * width, 1.0 * height};
  const char* separator = ": ";
  for (std::size_t axis = 0; axis < points.size(); ++axis) {
    if (!points[axis]) continue;
    const glm::dvec2 ndc = *points[axis], pixel = viewport.to_pixels(ndc);
    text += fmt::format("{}{} at NDC ({:.6g}, {:.6g}), pixel ({:.6g}, {:.6g})", separator, "xyz"[axis], ndc.x, ndc.y,
                        pixel.x, pixel.y);
    separator = "; ";
  }
  return text;
}

}  // namespace

CameraInfo describe_camera(const Scene& scene) {
  const CameraState camera = evaluate(scene.timeline, frame_numbers(scene.frames).front()).camera;
  const double aspect = static_cast<double>(scene.image.width) / scene.image.height;
  return {std::visit(Namer{}, camera.projection), window_text(camera.projection, aspect),
          vanishing_text(vanishing_points(camera.projection, aspect, camera.world_to_eye), scene.image.width,
                         scene.image.height)};
}

}  // namespace morphcl::cli
