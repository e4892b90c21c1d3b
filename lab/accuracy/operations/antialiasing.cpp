// Edges of a frame: what samples a pixel, and pictures drawn larger, miss of the exact areas of three objects.
//
// The objects are unlit and purely red, green and blue, so that a pixel's R, G and B are the shares that they have of
// it, and its alpha is that of all three.
#include <xxhash.h>

#include <ranges>

#include "lab/accuracy/operations/operations.hpp"
#include "lab/accuracy/random.hpp"
#include "lab/exact_coverage/coverage_error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"

namespace morphcl::accuracy {

namespace {

constexpr std::size_t channels = 4;

struct EdgeScene {
  Family family;
  Scene scene;
};

void add_colored(Scene& scene, const char* name, Mesh mesh, int color) {
  Object& object = scene.objects.emplace_back();
  object.name = name;
  object.mesh = static_cast<int>(scene.meshes.size());
  object.node = static_cast<int>(scene.timeline.nodes.size());
  object.material.shading = Shading::unlit;
  object.material.double_sided = true;
  object.material.base_color = {color == 0 ? 1.0 : 0.0, color == 1 ? 1.0 : 0.0, color == 2 ? 1.0 : 0.0, 1.0};
  object.morph.weights.assign(mesh.targets.size(), 0.0);
  scene.meshes.push_back(std::move(mesh));
  scene.timeline.nodes.emplace_back();
}

Scene scene_of_edges(bool quick) {
  Scene scene;
  scene.image.width = quick ? 96 : 320;
  scene.image.height = quick ? 54 : 180;
  scene.image.channels.erase(Channel::depth);
  scene.frames = {{.first = 0, .last = 0}};
  scene.timeline.camera.eye = {1.1, 1.9, 2.7};
  scene.timeline.camera.projection = Perspective{.fovy_degrees = 45, .near = 0.1, .far = 100};
  return scene;
}

// Triangles of about `size` anywhere in a box of 3 x 3 x 3.
Mesh chips(Random& random, int count, double size) {
  Mesh mesh;
  const auto point = [&](const glm::dvec3& around, double reach) {
    const double x = random.uniform(-reach, reach);
    const double y = random.uniform(-reach, reach);
    const double z = random.uniform(-reach, reach);
    return around + glm::dvec3(x, y, z);
  };
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 middle = point({0, 0, 0}, 1.5);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int k = 0; k < 3; ++k) mesh.positions.emplace_back(point(middle, size));
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

// Spokes of a wheel in the plane z = `z`, a thousandth of their length wide.
Mesh spokes(int count, double turn, double z) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const SinCos direction = sin_cos_degrees(turn + 360.0 * i / count);
    const glm::dvec3 out(direction.cos, direction.sin, 0), beside(-direction.sin, direction.cos, 0);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& p : {0.1 * out, 1.5 * out - 0.005 * beside, 1.5 * out + 0.005 * beside})
      mesh.positions.emplace_back(p + glm::dvec3(0, 0, z));
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

std::vector<EdgeScene> edge_scenes(const Settings& settings) {
  std::vector<EdgeScene> scenes;
  Scene benign = scene_of_edges(settings.quick);
  add_colored(benign, "teapot", make_solid("teapot"), 0);
  add_colored(benign, "torus", make_solid("torus"), 1);
  add_colored(benign, "grid", make_solid("grid"), 2);
  scenes.push_back({{"benign", "a teapot, a torus and a plane that pass through each other"}, benign});

  Random random(settings.seed);
  Scene wide = scene_of_edges(settings.quick);
  const char* const names[] = {"small", "middle", "large"};
  const double sizes[] = {0.01, 0.05, 0.2};
  for (int color = 0; color < 3; ++color)
    add_colored(wide, names[color], chips(random, settings.quick ? 300 : 1500, sizes[color]), color);
  scenes.push_back({{"wide", "triangles of a fraction of a pixel to some ten pixels, at random"}, wide});

  Scene adversarial = scene_of_edges(settings.quick);
  adversarial.timeline.camera.eye = {0, 0, 3.5};
  for (int color = 0; color < 3; ++color) add_colored(adversarial, names[color], spokes(60, 2 * color, 0), color);
  scenes.push_back({{"adversarial", "180 spokes of a wheel, thinner than a pixel"}, adversarial});
  for (EdgeScene& test : scenes) validate(test.scene);
  return scenes;
}

using Shares = std::array<double, channels>;

struct EdgePixel {
  int x, y;
  Shares exact;  // red, green, blue; all
};

// Those in which two of the objects, or one of them and nothing, have a part.
std::vector<EdgePixel> edge_pixels(const FramePlan& plan) {
  std::vector<EdgePixel> pixels;
  const ExactCoverage exact(plan);
  for (int y = 0; y < plan.height; ++y)
    exact.for_each_in_row(y, [&](int x, const PixelCoverage<double>& coverage) {
      EdgePixel pixel{x, y, {}};
      for (const SurfacePart& part : coverage.parts())
        if (part.draw != nothing_drawn) {
          pixel.exact[plan.draws[part.draw].object] += pixels_of(part.area);
          pixel.exact[3] += pixels_of(part.area);
        }
      const auto is_part = [&](double share) {
        return share > coverage.error_bound() && share < 1 - coverage.error_bound();
      };
      if (std::any_of(pixel.exact.begin(), pixel.exact.end(), is_part)) pixels.push_back(pixel);
    });
  return pixels;
}

// The mean of `scale` x `scale` pixels of the frame at each pixel of a smaller one.
double channel_at(const FrameBuffer& frame, std::size_t channel, int x, int y, int scale) {
  double sum = 0;
  for (int row = y * scale; row < (y + 1) * scale; ++row)
    for (int column = x * scale; column < (x + 1) * scale; ++column)
      sum += from_half(frame.color_row(static_cast<int>(channel), row)[static_cast<std::size_t>(column)]);
  return sum / (scale * scale);
}

std::uint64_t hash_of_colors(const FrameBuffer& frame) {
  XXH64_hash_t hash = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int channel = 0; channel < static_cast<int>(channels); ++channel) {
      const auto row = frame.color_row(channel, y);
      hash = XXH3_64bits_withSeed(row.data(), row.size_bytes(), hash);
    }
  return hash;
}

class EdgeRun {
 public:
  EdgeRun(const EdgeScene& test, const Settings& settings, OperationReport& report)
      : test_(test),
        settings_(settings),
        report_(report),
        measured_(scene_for_coverage(test.scene)),
        plan_(plan_frame(measured_, 0)),
        edges_(edge_pixels(*plan_)) {}

  void run() {
    const auto reference = make_reference_renderer();
    const auto device = settings_.session ? make_device_renderer(settings_.session) : nullptr;
    for (const auto& [renderer, where] :
         {std::pair(reference.get(), "host"), std::pair(device.get(), "device+transfer")}) {
      if (!renderer) continue;
      const std::string prefix = renderer == device.get() ? "device, " : "";
      // The most samples first, which the report's summary names.
      for (const int samples : sample_counts | std::views::reverse)
        draw(prefix + std::to_string(samples) + (samples == 1 ? " sample" : " samples"), *renderer, samples, 1, where);
      for (const int scale : {2, 4})
        draw(prefix + std::to_string(scale) + " x " + std::to_string(scale) + " pixels", *renderer, 1, scale, where);
    }
    Result exact = result("exact coverage", "host", false);
    exact.figures[Measure::rms_absolute] = exact.figures[Measure::max_absolute] = exact.figures[Measure::wrong] = 0;
    exact.hash = XXH3_64bits(edges_.data(), edges_.size() * sizeof(EdgePixel));
    volatile std::size_t found = 0;  // so that nothing is left out
    exact.timings.push_back(timed([&] { found = edge_pixels(*plan_).size(); }, "host"));
    report_.results.push_back(std::move(exact));
  }

 private:
  Result result(const std::string& variant, const char* place, bool ships) const {
    Result result;
    result.family = test_.family.name;
    result.variant = variant;
    result.ships = ships;
    result.place = place;
    result.compared = edges_.size();
    return result;
  }

  Timing timed(const std::function<void()>& run, const char* where) const {
    const auto pixels = static_cast<std::size_t>(plan_->width) * static_cast<std::size_t>(plan_->height);
    Timing timing = time_batch(run, pixels, {.runs = 30, .shortest_run_ns = 0});
    timing.where = where;
    timing.level = "L2";
    return timing;
  }

  void draw(const std::string& name, Renderer& renderer, int samples, int scale, const char* where) {
    Scene scene = test_.scene;
    scene.image.samples = samples;
    scene.image.width *= scale;
    scene.image.height *= scale;
    const Plan plan = plan_frame(scene, 0);
    FrameBuffer frame = plan.make_frame();
    renderer.render(plan, frame);
    Result drawn = result(name, where == std::string("host") ? "host" : "device", scale == 1);
    drawn.figures = figures_of(frame, scale);
    drawn.hash = hash_of_colors(frame);
    if (drawn.place == "host")
      host_hashes_.push_back(drawn.hash);
    else
      drawn.device_bits = drawn.hash == host_hashes_[next_of_device_++] ? "same" : "different";
    drawn.timings.push_back(timed([&] { renderer.render(plan, frame); }, where));
    report_.results.push_back(std::move(drawn));
  }

  Figures figures_of(const FrameBuffer& frame, int scale) const {
    double largest = 0, squares = 0;
    std::size_t beyond = 0;
    for (const EdgePixel& pixel : edges_) {
      double of_pixel = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        const double error = channel_at(frame, c, pixel.x, pixel.y, scale) - pixel.exact[c];
        squares += error * error;
        of_pixel = std::max(of_pixel, std::abs(error));
      }
      largest = std::max(largest, of_pixel);
      beyond += of_pixel > CoverageTally::limit;
    }
    const double count = static_cast<double>(edges_.size());
    Figures figures;
    figures[Measure::max_absolute] = largest;
    figures[Measure::rms_absolute] = std::sqrt(squares / (channels * count));
    figures[Measure::wrong] = 1e6 * static_cast<double>(beyond) / count;
    return figures;
  }

  const EdgeScene& test_;
  const Settings& settings_;
  OperationReport& report_;
  const Scene measured_;
  const Plan plan_;
  const std::vector<EdgePixel> edges_;
  std::vector<std::uint64_t> host_hashes_;  // of each variant
  std::size_t next_of_device_ = 0;
};

}  // namespace

Operation antialiasing() {
  const Description about = {.name = "antialiasing",
                             .title =
                                 "the pixels of a frame where objects meet, colour alone; times are for a pixel of "
                                 "the frame, drawing alone where it is drawn larger",
                             .results = "share of a pixel that an object has, as R, G, B or A; wrong: beyond 1/255",
                             .format = {11, -14},
                             .plotted = Measure::rms_absolute,
                             .target = 1.0 / 16,
                             .reason = "what one of sixteen samples is worth",
                             .element = "a pixel"};
  return {about, [about](const Settings& settings) {
            OperationReport report;
            report.about = about;
            for (const EdgeScene& test : edge_scenes(settings)) {
              report.families.push_back(test.family);
              EdgeRun(test, settings, report).run();
            }
            return report;
          }};
}

}  // namespace morphcl::accuracy
