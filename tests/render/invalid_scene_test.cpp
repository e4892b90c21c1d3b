// A scene that is not valid is refused when a planner takes it, by the same words from everyone who makes one:
// Error(usage).
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "morphcl/error.hpp"
#include "morphcl/job.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"

namespace morphcl::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Scene valid_scene() {
  Scene scene;
  scene.image.width = 40;
  scene.image.height = 30;
  scene.frames = {{0, 10, 1}};
  scene.add_object("solid", make_pyramid_to_cube());
  scene.timeline.camera.eye = {3, 2, 6};
  scene.timeline.lights.emplace_back();
  return scene;
}

struct Fault {
  const char* name;
  std::function<void(Scene&)> make;
  const char* text;  // a part of what is said
};

const Fault faults[] = {
    {"mesh past the end", [](Scene& s) { s.objects[0].mesh = 1; }, "object 0 \"solid\": mesh 1 of 1"},
    {"negative mesh", [](Scene& s) { s.objects[0].mesh = -1; }, "mesh -1 of 1"},
    {"node past the end", [](Scene& s) { s.objects[0].node = 7; }, "node 7 of 1"},
    {"no nodes", [](Scene& s) { s.timeline.nodes.clear(); }, "node 0 of 0"},
    {"weight too few", [](Scene& s) { s.objects[0].morph.weights.clear(); }, "0 weights for 1 morph targets"},
    {"weight too many", [](Scene& s) { s.objects[0].morph.weights.push_back(1); }, "2 weights for 1 morph targets"},
    {"weight not finite", [](Scene& s) { s.objects[0].morph.weights[0] = nan; }, "weight"},
    {"track past the targets",
     [](Scene& s) { s.objects[0].morph.tracks.push_back({1, Track::linear(s.timeline.time, {{0, 0.0}, {9, 1.0}})}); },
     "target"},
    {"colour not finite", [](Scene& s) { s.objects[0].material.base_color.y = nan; }, "base colour"},
    {"no such shading", [](Scene& s) { s.objects[0].material.shading = static_cast<Shading>(9); }, "shading"},
    {"no such depth buffer", [](Scene& s) { s.image.depth_format = static_cast<DepthFormat>(9); }, "depth buffer"},
    {"samples of no pattern", [](Scene& s) { s.image.samples = 3; },
     "3 samples a pixel; 1, 2, 4, 8 or 16 are possible"},
    {"no samples", [](Scene& s) { s.image.samples = 0; }, "0 samples a pixel"},
    {"lines without width", [](Scene& s) { s.objects[0].material.line_width = 0; }, "lines 0 pixels wide"},
    {"lines too wide", [](Scene& s) { s.objects[0].material.line_width = 257; }, "lines 257 pixels wide"},
    {"line width not a number", [](Scene& s) { s.objects[0].material.line_width = nan; }, "pixels wide"},
    {"vertex index past the end", [](Scene& s) { s.meshes[0].triangles[2].y = 1000; }, "mesh"},
    {"position not finite", [](Scene& s) { s.meshes[0].positions[3].z = std::numeric_limits<float>::infinity(); },
     "mesh"},
    {"no positions", [](Scene& s) { s.meshes[0].positions.clear(); }, "mesh"},
    {"a normal too few", [](Scene& s) { s.meshes[0].normals.resize(3, glm::vec3(0, 0, 1)); }, "mesh"},
    {"target of another length", [](Scene& s) { s.meshes[0].targets[0].positions.pop_back(); }, "mesh"},
    {"no width", [](Scene& s) { s.image.width = 0; }, "an image of 0 x 30 pixels"},
    {"huge image", [](Scene& s) { s.image.height = 16385; }, "an image of 40 x 16385 pixels"},
    {"no channel", [](Scene& s) { s.image.channels = {}; }, "no channel"},
    {"negative error of Z", [](Scene& s) { s.image.z_error = -1e-6; }, "relative error of -1e-06"},
    {"error of Z not finite", [](Scene& s) { s.image.z_error = nan; }, "relative error of nan"},
    {"error of Z too large", [](Scene& s) { s.image.z_error = 0.2; }, "at most 0.1"},
    {"error of Z without Z",
     [](Scene& s) {
       s.image.z_error = 1e-6;
       s.image.channels.erase(Channel::depth);
     },
     "no channel Z"},
    {"accuracy not finite", [](Scene& s) { s.accuracy_pixels = nan; }, "accuracy"},
    {"negative accuracy", [](Scene& s) { s.accuracy_pixels = -1; }, "accuracy"},
    {"nodes in a circle",
     [](Scene& s) {
       s.timeline.nodes.emplace_back().parent = 0;
       s.timeline.nodes[0].parent = 1;
     },
     ""},
    {"parent past the end", [](Scene& s) { s.timeline.nodes[0].parent = 5; }, "parent"},
    {"camera node past the end", [](Scene& s) { s.timeline.camera.node = 5; }, "camera"},
    {"eye not finite", [](Scene& s) { s.timeline.camera.eye.x = nan; }, ""},
    {"no field of view", [](Scene& s) { s.timeline.camera.projection = Perspective{0, 1, 10}; }, ""},
    {"near behind far", [](Scene& s) { s.timeline.camera.projection = Perspective{45, 10, 1}; }, ""},
    {"rate of 0", [](Scene& s) { s.timeline.time.fps_numerator = 0; }, ""},
    {"light not finite", [](Scene& s) { s.timeline.lights[0].vector.x = nan; }, ""},
    {"frames backwards", [](Scene& s) { s.frames = {{5, 1, 1}}; }, ""},
    {"frames without a step", [](Scene& s) { s.frames = {{0, 5, 0}}; }, ""},
};

// What is said; "" where nothing is.
std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage) << error.what();
    return error.what();
  }
  return "";
}

TEST(InvalidScene, IsRefusedByThePlannerAndByAJob) {
  ASSERT_EQ(refusal([] {
              const Scene scene = valid_scene();
              plan_frame(scene, 3);
            }),
            "");
  const auto renderer = make_reference_renderer();
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.name);
    Scene scene = valid_scene();
    fault.make(scene);
    const std::string planner = refusal([&] { const Planner made(scene); });
    EXPECT_NE(planner, "");
    EXPECT_NE(planner.find(fault.text), std::string::npos) << planner;
    EXPECT_EQ(planner.find('\n'), std::string::npos) << planner;
    EXPECT_EQ(refusal([&] { plan_frame(scene, 0); }), planner);
    EXPECT_EQ(refusal([&] { run({.pattern = "/nowhere/a.####.exr", .frames = {0}}, scene, *renderer); }), planner);
  }
}

TEST(InvalidScene, OneWithoutFramesOrObjectsIsValid) {
  Scene scene = valid_scene();
  scene.frames.clear();
  EXPECT_EQ(refusal([&] { plan_frame(scene, 3); }), "");
  EXPECT_EQ(refusal([&] {
              const Scene empty;
              plan_frame(empty, 3);
            }),
            "");
}

}  // namespace
}  // namespace morphcl::test
