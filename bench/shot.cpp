// morphcl_bench_shot SCENE [--amount N] [--frames N] [--size WxH]: prints the scene as a shot file, for the command
// line tool. Scenes: morph, wire and heavy, which are built-in solids.

#include <fmt/format.h>

#include "bench/options.hpp"
#include "bench/scenes.hpp"
#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

std::string list(const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

// The built-in pyramid stands on (50, 50, 30) to (150, 150, 30), z up, and grows to z = 100; the scene's has half-edge
// 1 around the origin, y up.
constexpr const char* pyramid = R"(mesh = "pyramid_to_cube"
[[object.transform]]
translate = [-100, -100, -65]
[[object.transform]]
scale = [0.02, 0.02, 0.02857142857142857]
[[object.transform]]
rotate_x_degrees = -90
)";

std::string solid(const BenchScene& scene) {
  if (scene.name == "morph" || scene.name == "wire") return pyramid;
  if (scene.name != "heavy")
    throw Error(ErrorKind::usage, "", fmt::format("there is no shot of scene {}", printable(scene.name)));
  const auto cells = static_cast<int>(std::lround(std::sqrt(static_cast<double>(scene.shape.triangles.size()) / 12.0)));
  return fmt::format("mesh = \"sphere_to_cube\"\nsegments = [{}, {}]\n", 4 * cells, 2 * cells);
}

void run(const Options& options) {
  const BenchScene scene = make_bench_scene(options.scene, options.width, options.height, options.amount);
  const int frames = options.frames > 0 ? options.frames : scene.frames;
  const bool lines = scene.surface == Surface::lines;
  fmt::print("ambient = {}\n[image]\nsize = [{}, {}]\n[frames]\nrange = \"0-{}\"\n", list(ambient / base_color),
             scene.width, scene.height, frames - 1);
  fmt::print("[camera]\nfovy_degrees = {}\nnear = {}\nfar = {}\neye = {}\ntarget = {}\n", fovy_degrees, near_plane,
             far_plane, list(scene.eye), list(scene.target));
  fmt::print("[[light]]\ndirection = {}\n[[object]]\nshading = \"{}\"\ncolor = {}\n", list(light_direction),
             lines                            ? "wireframe"
             : scene.surface == Surface::flat ? "flat"
                                              : "smooth",
             list(lines ? glm::dvec3(1.0) : base_color));
  fmt::print("{}[[object.track]]\ntarget = \"morph.cube\"\nkeys = [[0, 0.0]{}]\n", solid(scene),
             frames > 1 ? fmt::format(", [{}, 1.0]", frames - 1) : "");
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  try {
    const auto options =
        morphcl::bench::parse_options(argc, argv, "Prints a scene as a shot file: morph, wire, heavy.");
    if (options) morphcl::bench::run(*options);
    return 0;
  } catch (const morphcl::Error& error) {
    fmt::print(stderr, "morphcl_bench_shot: {}\n", error.what());
    return error.exit_code();
  }
}
