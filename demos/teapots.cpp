// Five teapots between the near and the far plane: o shows them all of one size, f the nearest ones larger.
#include "demos/viewer/run_demo.hpp"

int main(int argc, char** argv) {
  const morphcl::viewer::DemoSettings settings{
      .name = "teapots",
      .description = "Five teapots in orthographic projection and in a frustum, from an eye that moves up and down.",
      .shot = "teapots.toml",
      .width = 600,
      .height = 600,
      .orthographic = morphcl::Orthographic{.left = -5, .right = 5, .bottom = -5, .top = 5, .near = -10, .far = 10},
      .frustum = morphcl::Frustum{.left = -2, .right = 2, .bottom = -2, .top = 2, .near = 3, .far = 10},
      .first_projection = morphcl::viewer::ProjectionKind::orthographic,
      .background = {{1, 1, 1}},
      .lights_follow_eye = true,
  };
  return morphcl::viewer::run_demo(settings, argc, argv);
}
