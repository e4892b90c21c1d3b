// Renders a pyramid that turns into a cube: 101 frames, first.0000.exr to first.0100.exr.
#include <cstdio>
#include <morphcl/morphcl.hpp>

int main() try {
  using namespace morphcl;
  Scene scene;
  scene.image.width = 640;
  scene.image.height = 360;
  scene.frames = {{.first = 0, .last = 100}};

  CompositeTransform placing;  // the box's centre to the origin, its edges to length 1, turned
  placing.translate({-100, -100, -65}).scale({0.01, 0.01, 0.01}).rotate_about_axis({0, 0, 0}, {1, 0, 1}, 30);
  const int solid = scene.add_object("solid", make_solid("pyramid_to_cube"), placing);
  scene.morph(solid, "cube", Track::linear(scene.timeline.time, {{0, 0.0}, {100, 1.0}}));
  scene.timeline.camera.eye = {1.1, 0.9, 1.7};
  scene.timeline.lights.emplace_back().vector = {0.4, 0.7, 0.9};

  const auto renderer = make_device_renderer(Session::open({}));
  const JobResult result = run({.pattern = "first.####.exr"}, scene, *renderer);
  std::printf("%zu frames on %s\n", result.frames.size(), renderer->name().c_str());
} catch (const morphcl::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return error.exit_code();
}
