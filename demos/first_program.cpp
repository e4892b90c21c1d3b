// Renders a pyramid that turns into a cube: 101 frames, first.0000.exr to first.0100.exr.
#include <cstdio>
#include <morphcl/morphcl.hpp>

int main() try {
  using namespace morphcl;
  Scene scene;
  scene.image.width = 640;
  scene.image.height = 360;
  scene.frames = {{.first = 0, .last = 100}};
  scene.meshes = {make_solid("pyramid_to_cube")};
  scene.objects.emplace_back().name = "solid";

  CompositeTransform placing;  // the box's centre to the origin, its edges to length 1, turned
  placing.translate({-100, -100, -65}).scale({0.01, 0.01, 0.01}).rotate_about_axis({0, 0, 0}, {1, 0, 1}, 30);
  scene.timeline.nodes.emplace_back().static_transform = placing.matrix();

  const TimeBase time = scene.timeline.time;  // 25 frames per second
  const Track growing(Interpolation::linear, 1, false, time.ticks_per_second(), {0, time.frame_ticks(100)}, {0, 1});
  scene.timeline.weights = {{.weights = {0}, .tracks = {{.first_target = 0, .track = growing}}}};
  scene.timeline.camera.eye = {1.1, 0.9, 1.7};
  scene.timeline.lights.emplace_back().vector = {0.4, 0.7, 0.9};
  validate(scene);

  prepare_process(0);
  const auto renderer = make_device_renderer(Session::open({}));
  RenderJob job;
  job.pattern = "first.####.exr";
  job.frames = frame_numbers(scene.frames);
  job.fingerprint = fingerprint(scene);
  const JobResult result = run(job, scene, *renderer);
  std::printf("%zu frames on %s\n", result.frames.size(), renderer->name().c_str());
} catch (const morphcl::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return error.exit_code();
}
