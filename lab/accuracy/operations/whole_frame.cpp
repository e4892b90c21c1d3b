// A whole frame: what the renderers draw beside an fp64 render of the same scene.
#include <xxhash.h>

#include "host/render/frame/frame_plan.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "lab/frame_error/frame_difference.hpp"
#include "lab/frame_error/precise_frame.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"

namespace morphcl::accuracy {

namespace {

constexpr int width = 320, height = 180;
constexpr double pixel_count = width * height;

struct TestScene {
  Family family;
  Scene scene;
};

void add_object(Scene& scene, const char* name, Mesh mesh, const glm::dvec3& place, Shading shading) {
  Object& object = scene.objects.emplace_back();
  object.name = name;
  object.mesh = static_cast<int>(scene.meshes.size());
  object.node = static_cast<int>(scene.timeline.nodes.size());
  object.material.shading = shading;
  object.material.double_sided = true;
  scene.meshes.push_back(std::move(mesh));
  scene.timeline.nodes.emplace_back().translation = place;
  object.morph.weights.assign(scene.meshes.back().targets.size(), 0.0);
}

Scene empty_scene(const glm::dvec3& eye, const glm::dvec3& target, const Perspective& projection) {
  Scene scene;
  scene.image.width = width;
  scene.image.height = height;
  scene.frames = {{.first = 0, .last = 0}};
  scene.timeline.camera.eye = eye;
  scene.timeline.camera.target = target;
  scene.timeline.camera.projection = projection;
  scene.timeline.lights.emplace_back().vector = {0.4, 0.7, 0.9};
  return scene;
}

std::vector<TestScene> test_scenes() {
  std::vector<TestScene> scenes;
  Scene benign = empty_scene({1.1, 1.9, 2.7}, {0, 0, 0}, {.fovy_degrees = 45, .near = 0.1, .far = 100});
  add_object(benign, "teapot", make_solid("teapot"), {0, 0, 0}, Shading::smooth);
  scenes.push_back({{"benign", "a teapot 3.5 from the eye, near 0.1, far 100; 320 x 180 pixels"}, benign});

  const glm::dvec3 far_away(10000, 13000, -9000);
  Scene wide = empty_scene(far_away + glm::dvec3(1.1, 1.9, 2.7), far_away, {.near = 0.001, .far = 1e5});
  add_object(wide, "teapot", make_solid("teapot"), far_away, Shading::smooth);
  add_object(wide, "ground", make_solid("grid"), far_away + glm::dvec3(0, -0.8, 0), Shading::flat);
  scenes.push_back({{"wide", "the same with a ground, 19000 from the origin, near 0.001, far 100000"}, wide});

  Scene adversarial = empty_scene({0.3, 0.05, 2}, {0, 0, 0}, {.near = 0.001, .far = 1e5});
  add_object(adversarial, "grid", make_solid("grid", Segments{200, 1}), {0, 0, 0}, Shading::flat);
  add_object(adversarial, "grid just below", make_solid("grid", Segments{1, 200}), {0, -1e-5, 0}, Shading::flat);
  add_object(adversarial, "thin torus", make_solid("torus", Segments{512, 3}), {0, 0.1, 0}, Shading::smooth);
  scenes.push_back({{"adversarial", "thin triangles seen at a grazing angle, two planes 10^-5 apart"}, adversarial});
  for (TestScene& test : scenes) validate(test.scene);
  return scenes;
}

std::uint64_t hash_of_frame(const FrameBuffer& frame) {
  XXH64_hash_t hash = 0;
  for (int y = 0; y < height; ++y) {
    const auto add = [&](const auto& row) { hash = XXH3_64bits_withSeed(row.data(), row.size_bytes(), hash); };
    for (int channel = 0; channel < 4; ++channel) add(frame.color_row(channel, y));
    add(frame.depth_row(y));
  }
  return hash;
}

Figures figures_of(const FrameDifference& difference) {
  const Differences& all = difference.total;
  const auto per_million = [](std::size_t pixels) { return 1e6 * static_cast<double>(pixels) / pixel_count; };
  Figures figures;
  figures[Measure::max_ulp] = all.color_spacing.all.largest;
  figures[Measure::rms_ulp] = all.color_spacing.all.rms();
  figures[Measure::max_absolute] = all.color.all.largest;
  figures[Measure::rms_absolute] = all.color.all.rms();
  figures[Measure::wrong] = per_million(all.outline + all.edge + all.order);
  figures[Measure::inversions] = per_million(all.order);
  figures[Measure::not_finite] = static_cast<double>(all.color.all.not_finite + all.depth.all.not_finite);
  return figures;
}

// Everything that the fp64 render shows; returns a sum so that nothing is left out.
double draw_in_fp64(const Scene& scene) {
  const PreciseFrame<OnGrid<double>> frame(scene, 0);
  const auto visible = frame.find_visible();
  double sum = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto& pixel = visible[static_cast<std::size_t>(y) * width + x];
      if (pixel.object == no_object) continue;
      if (const auto hit = frame.hit(pixel.object, pixel.primitive, x, y))
        sum += frame.color(pixel.object, pixel.primitive, *hit, x, y).x;
    }
  return sum;
}

Timing timed(const std::function<void()>& run, const char* where) {
  Timing timing = time_batch(run, static_cast<std::size_t>(pixel_count), {.runs = 30, .shortest_run_ns = 0});
  timing.where = where;
  timing.level = "L2";
  return timing;
}

class SceneRun {
 public:
  SceneRun(const TestScene& test, const Settings& settings, OperationReport& report)
      : test_(test),
        settings_(settings),
        report_(report),
        plan_(plan_frame(test.scene, 0)),
        shown_(reference::shown_pixels(*plan_)) {}

  void run() {
    draw("reference renderer", *make_reference_renderer(), plan_, "host");
    for (const DepthFormat format : {DepthFormat::forward_float, DepthFormat::fixed24, DepthFormat::fixed16})
      draw_with_depth(format);
    if (settings_.session) {
      const auto device = make_device_renderer(settings_.session);
      draw("device renderer", *device, plan_, "device+transfer");
      const Plan all = plan_frame(test_.scene, 0, {.leave_out = false});
      draw("device, nothing left out", *make_device_renderer(settings_.session), all, "device+transfer");
    }
    Result exact = result("fp64 render", "host");
    exact.ships = false;
    exact.figures[Measure::wrong] = exact.figures[Measure::max_absolute] = exact.figures[Measure::not_finite] = 0;
    const double sum = draw_in_fp64(test_.scene);
    exact.hash = XXH3_64bits(&sum, sizeof sum);
    volatile double shown = 0;  // so that no drawing is left out
    exact.timings.push_back(timed([&] { shown = draw_in_fp64(test_.scene); }, "host"));
    report_.results.push_back(std::move(exact));
  }

 private:
  Result result(const char* variant, const char* place) const {
    Result result;
    result.family = test_.family.name;
    result.variant = variant;
    result.ships = true;
    result.place = place;
    result.compared = static_cast<std::size_t>(pixel_count);
    return result;
  }

  void draw_with_depth(DepthFormat format) {
    Scene scene = test_.scene;
    scene.image.depth_format = format;
    const Plan plan = plan_frame(scene, 0);
    FrameBuffer pixels(width, height, {Channel::color, Channel::depth});
    const auto renderer = make_reference_renderer();
    renderer->render(plan, pixels);
    Result drawn = result(("depth as " + std::string(name_of(format))).c_str(), "host");
    drawn.figures = figures_of(compare_with_fp64(scene, *plan, pixels, reference::shown_pixels(*plan), Truth::on_grid));
    drawn.hash = hash_of_frame(pixels);
    drawn.timings.push_back(timed([&] { renderer->render(plan, pixels); }, "host"));
    report_.results.push_back(std::move(drawn));
  }

  void draw(const char* name, Renderer& renderer, const Plan& plan, const char* where) {
    FrameBuffer pixels(width, height, {Channel::color, Channel::depth});
    renderer.render(plan, pixels);
    Result drawn = result(name, where == std::string("host") ? "host" : "device");
    drawn.figures = figures_of(compare_with_fp64(test_.scene, *plan_, pixels, shown_, Truth::on_grid));
    drawn.hash = hash_of_frame(pixels);
    if (report_.results.empty() || report_.results.back().family != test_.family.name)
      host_hash_ = drawn.hash;
    else
      drawn.device_bits = drawn.hash == host_hash_ ? "same" : "different";
    drawn.timings.push_back(timed([&] { renderer.render(plan, pixels); }, where));
    report_.results.push_back(std::move(drawn));
  }

  const TestScene& test_;
  const Settings& settings_;
  OperationReport& report_;
  const Plan plan_;
  const std::vector<reference::ShownPixel> shown_;
  std::uint64_t host_hash_ = 0;
};

}  // namespace

Operation whole_frame() {
  const Description about = {.name = "whole-frame",
                             .title = "a frame of 320 x 180 pixels, colour and depth; times are for a pixel",
                             .results = "colour, stored as half",
                             .format = {11, -14},
                             .plotted = Measure::wrong,
                             .target = 100,
                             .reason = "one pixel in ten thousand shows another triangle than in fp64",
                             .element = "a pixel"};
  return {about, [about](const Settings& settings) {
            OperationReport report;
            report.about = about;
            for (const TestScene& test : test_scenes()) {
              report.families.push_back(test.family);
              SceneRun(test, settings, report).run();
            }
            return report;
          }};
}

}  // namespace morphcl::accuracy
