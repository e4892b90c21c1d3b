// What a shot says, as a scene.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "morphcl/error.hpp"
#include "morphcl/transform.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

// Everything that the file format has, each value different from its default.
constexpr std::string_view full_shot = R"(
ambient = [0.1, 0.2, 0.3]
[image]
size = [320, 180]
channels = ["crypto_object", "Z", "velocity", "P", "N"]
channel_names = "nuke"
samples = 8
compression = "piz"
depth_buffer = "fixed24"
z_error = 1e-6
p_error = 1e-5
n_error = 1e-3
[accuracy]
pixels = 0.01
[frames]
range = "0-10,20"
fps = [30000, 1001]
[camera]
projection = "perspective"
fovy_degrees = 30
near = 0.5
far = inf
eye = [1, 2, 3]
target = [0.5, 0, 0]
up = [0, 0, 1]
[[light]]
direction = [1, 2, 3]
color = [1.0, 0.5, 0.25]
intensity = 2
[[light]]
position = [0, 5, 0]
falloff = true
[[object]]
name = "ball"
mesh = "sphere"
segments = [5, 4]
shading = "unlit"
color = [0.1, 0.2, 0.3, 0.4]
double_sided = true
[[object]]
mesh = "cube"
shading = "wireframe"
line_width = 2.5
)";

TEST(Shot, ReadsImageFramesAndAmbient) {
  const Scene scene = ShotFolder().load(full_shot);
  EXPECT_EQ(scene.name, "shot");
  EXPECT_EQ(scene.image.width, 320);
  EXPECT_EQ(scene.image.height, 180);
  EXPECT_EQ(scene.image.channels, (ChannelSet{Channel::depth, Channel::normal, Channel::position, Channel::velocity,
                                              Channel::crypto_object}));
  EXPECT_EQ(scene.image.channel_names, ChannelNames::nuke);
  EXPECT_EQ(scene.image.compression, "piz");
  EXPECT_EQ(scene.image.depth_format, DepthFormat::fixed24);
  EXPECT_EQ(scene.image.z_error, 1e-6);
  EXPECT_EQ(scene.image.p_error, 1e-5);
  EXPECT_EQ(scene.image.n_error, 1e-3);
  EXPECT_EQ(scene.image.samples, 8);
  EXPECT_EQ(scene.accuracy_pixels, 0.01);
  EXPECT_EQ(frame_numbers(scene.frames).size(), 12u);
  EXPECT_EQ(scene.timeline.time.fps_numerator, 30000);
  EXPECT_EQ(scene.timeline.time.fps_denominator, 1001);
  EXPECT_EQ(scene.timeline.ambient, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(scene.content_hash.size(), 32u);
}

TEST(Shot, ReadsCameraAndLights) {
  const Scene scene = ShotFolder().load(full_shot);
  const Camera& camera = scene.timeline.camera;
  const auto& perspective = std::get<Perspective>(camera.projection);
  EXPECT_EQ(perspective.fovy_degrees, 30);
  EXPECT_EQ(perspective.near, 0.5);
  EXPECT_EQ(perspective.far, INFINITY);
  EXPECT_EQ(camera.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(camera.target, glm::dvec3(0.5, 0, 0));
  EXPECT_EQ(camera.up, glm::dvec3(0, 0, 1));
  ASSERT_EQ(scene.timeline.lights.size(), 2u);
  const Light &directional = scene.timeline.lights[0], &point = scene.timeline.lights[1];
  EXPECT_EQ(directional.kind, LightKind::directional);
  EXPECT_EQ(directional.vector, glm::dvec3(1, 2, 3));
  EXPECT_EQ(directional.color, glm::dvec3(2, 1, 0.5));
  EXPECT_FALSE(directional.falloff);
  EXPECT_EQ(point.kind, LightKind::point);
  EXPECT_EQ(point.vector, glm::dvec3(0, 5, 0));
  EXPECT_EQ(point.color, glm::dvec3(1));
  EXPECT_TRUE(point.falloff);
}

TEST(Shot, ReadsObjects) {
  const Scene scene = ShotFolder().load(full_shot);
  ASSERT_EQ(scene.objects.size(), 2u);
  const Object &ball = scene.objects[0], &cube = scene.objects[1];
  EXPECT_EQ(ball.name, "ball");
  EXPECT_EQ(ball.material.shading, Shading::unlit);
  EXPECT_EQ(ball.material.base_color, glm::dvec4(0.1, 0.2, 0.3, 0.4));
  EXPECT_TRUE(ball.material.double_sided);
  EXPECT_EQ(scene.meshes[ball.mesh].positions.size(), 30u);
  EXPECT_EQ(cube.name, "cube");
  EXPECT_EQ(cube.material.shading, Shading::wireframe);
  EXPECT_EQ(cube.material.base_color, glm::dvec4(0.8, 0.8, 0.8, 1));
  EXPECT_FALSE(cube.material.double_sided);
  EXPECT_EQ(cube.material.line_width, 2.5);
  EXPECT_EQ(ball.material.line_width, 1);
  EXPECT_EQ(scene.meshes[cube.mesh].positions.size(), 24u);
}

TEST(Shot, HasTheDocumentedDefaults) {
  const Scene scene = ShotFolder().load(test::cube_object);
  EXPECT_EQ(scene.image.width, 1920);
  EXPECT_EQ(scene.image.height, 1080);
  EXPECT_TRUE(scene.image.has_color() && scene.image.has_depth());
  EXPECT_EQ(scene.image.compression, "zip");
  EXPECT_EQ(scene.image.depth_format, DepthFormat::reversed_float);
  EXPECT_EQ(scene.image.samples, 1);
  EXPECT_EQ(scene.accuracy_pixels, 0);
  EXPECT_EQ(frame_numbers(scene.frames), std::vector<std::int64_t>{0});
  EXPECT_EQ(scene.timeline.time.fps_numerator, 25);
  EXPECT_FALSE(scene.image.background);
  EXPECT_EQ(scene.timeline.ambient, glm::dvec3(0.1));
  ASSERT_EQ(scene.timeline.lights.size(), 3u);
  EXPECT_EQ(scene.timeline.lights[0].vector, glm::dvec3(0.4, 0.7, 0.9));
  EXPECT_EQ(scene.timeline.lights[0].color, glm::dvec3(0.62));
  EXPECT_EQ(scene.objects[0].material.shading, Shading::smooth);
}

TEST(Shot, Backgrounds) {
  const auto background = [](const std::string& value) {
    return ShotFolder().load("[image]\nbackground = " + value + "\n" + std::string(test::cube_object)).image.background;
  };
  EXPECT_FALSE(background("\"none\""));
  EXPECT_EQ(background("[0, 0.5, 1]")->top, glm::dvec3(0, 0.5, 1));
  EXPECT_EQ(background("[0, 0.5, 1]")->bottom, glm::dvec3(0, 0.5, 1));
  EXPECT_EQ(background("[[1, 0, 0], [0, 2, 0]]")->top, glm::dvec3(1, 0, 0));
  EXPECT_EQ(background("[[1, 0, 0], [0, 2, 0]]")->bottom, glm::dvec3(0, 2, 0));
}

TEST(Shot, WithAnEmptyListOfLightsIsDark) {
  EXPECT_TRUE(ShotFolder().load("light = []\n" + std::string(test::cube_object)).timeline.lights.empty());
}

TEST(Shot, ReadsTheOtherProjections) {
  const ShotFolder folder;
  const std::string window = "left = -2\nright = 3\nbottom = -4\ntop = 5\nnear = 6\nfar = 7\n";
  const auto projection = [&](const std::string& name) {
    return folder.load("[camera]\nprojection = \"" + name + "\"\n" + window + std::string(test::cube_object))
        .timeline.camera.projection;
  };
  const auto frustum = std::get<Frustum>(projection("frustum"));
  EXPECT_EQ((std::vector{frustum.left, frustum.right, frustum.bottom, frustum.top, frustum.near, frustum.far}),
            (std::vector<double>{-2, 3, -4, 5, 6, 7}));
  const auto planes = std::get<Orthographic>(projection("orthographic"));
  EXPECT_EQ((std::vector{planes.left, planes.right, planes.bottom, planes.top, planes.near, planes.far}),
            (std::vector<double>{-2, 3, -4, 5, 6, 7}));
}

TEST(Shot, AppliesTransformStepsInTheOrderWritten) {
  const Scene scene = ShotFolder().load(R"(
[[object]]
mesh = "cube"
[[object.transform]]
translate = [1, 2, 3]
[[object.transform]]
scale = [2, 3, 4]
[[object.transform]]
scale_about = { point = [100, 100, 30], factor = [0.5, 0.25, 0.125] }
[[object.transform]]
rotate_x_degrees = 10
[[object.transform]]
rotate_y_degrees = 20
[[object.transform]]
rotate_z_degrees = 30
[[object.transform]]
rotate_about_axis = { from = [1, 0, 0], to = [1, 0, 5], degrees = 40 }
[[object.transform]]
shear = { xy = 0.1, xz = 0.2, yx = 0.3, yz = 0.4, zx = 0.5, zy = 0.6 }
[[object.transform]]
matrix = [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [0, 0, 0, 1]]
)");
  CompositeTransform expected;
  expected.translate({1, 2, 3}).scale({2, 3, 4}).scale_about({100, 100, 30}, {0.5, 0.25, 0.125});
  expected.rotate_x_degrees(10).rotate_y_degrees(20).rotate_z_degrees(30);
  expected.rotate_about_axis({1, 0, 0}, {1, 0, 5}, 40).shear(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
  expected.matrix_step(glm::dmat4({1, 5, 9, 0}, {2, 6, 10, 0}, {3, 7, 11, 0}, {4, 8, 12, 1}));
  EXPECT_EQ(scene.timeline.nodes[scene.objects[0].node - 1].static_transform, expected.matrix());
}

// The same map in three conventions: turned about z, moved, and scaled along z.
TEST(Shot, MatricesOfOtherConventionsAreTurnedIntoOurs) {
  const auto transform = [](const std::string& matrix) {
    const Scene scene =
        ShotFolder().load(std::string(test::cube_object) + "[[object.transform]]\nmatrix = " + matrix + "\n");
    return scene.timeline.nodes[scene.objects[0].node - 1].static_transform;
  };
  const glm::dmat4 own = transform("[[0, -1, 0, 4], [1, 0, 0, 5], [0, 0, 2, 6], [0, 0, 0, 1]]");
  EXPECT_EQ(own * glm::dvec4(1, 2, 3, 1), glm::dvec4(2, 6, 12, 1));
  EXPECT_EQ(own,
            transform("{ rows = [[0, -1, 0, 4], [1, 0, 0, 5], [0, 0, 2, 6], [0, 0, 0, 1]], vectors = \"column\" }"));
  EXPECT_EQ(own, transform("{ rows = [[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 2, 0], [4, 5, 6, 1]], vectors = \"row\" }"));
  EXPECT_EQ(own,
            transform("{ rows = [[0, -1, 0, 4], [1, 0, 0, 5], [0, 0, 2, -6], [0, 0, 0, 1]], handedness = \"left\" }"));
}

TEST(Shot, ShowsEachOfTheSevenSteps) {
  const auto transform = [](const std::string& steps) {
    const Scene scene =
        ShotFolder().load(std::string(test::cube_object) +
                          "[[object.transform]]\nrotate_in_seven_steps = { from = [1, 2, 3], to = [2, 0, "
                          "4], degrees = 60" +
                          steps + " }\n");
    return scene.timeline.nodes[scene.objects[0].node - 1].static_transform;
  };
  const std::vector<TransformStep> all = rotation_in_seven_steps({1, 2, 3}, {2, 0, 4}, 60).steps();
  EXPECT_EQ(transform(", steps = 0"), glm::dmat4(1.0));
  EXPECT_EQ(transform(", steps = 3"), all[2].matrix * (all[1].matrix * all[0].matrix));
  const glm::dmat4 whole = transform(""),
                   stable = CompositeTransform().rotate_about_axis({1, 2, 3}, {2, 0, 4}, 60).matrix();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(whole[c][r], stable[c][r], 1e-14);
}

TEST(Shot, SharesTheMeshesOfItsObjects) {
  const Scene scene = ShotFolder().load(R"(
[[object]]
mesh = "sphere"
[[object]]
mesh = "sphere"
[[object]]
mesh = "sphere"
segments = [8, 8]
[[object]]
mesh = "sphere"
segments = [8, 8]
)");
  EXPECT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.objects[0].mesh, scene.objects[1].mesh);
  EXPECT_EQ(scene.objects[2].mesh, scene.objects[3].mesh);
  EXPECT_NE(scene.objects[0].node, scene.objects[1].node);
}

TEST(Shot, TakesWhatTheCallerDecides) {
  LoadOptions options;
  options.fps = TimeBase{24, 1};
  options.width = 64;
  options.height = 32;
  const Scene scene = ShotFolder().load(full_shot, options);
  EXPECT_EQ(scene.timeline.time.fps_numerator, 24);
  EXPECT_EQ(scene.image.width, 64);
  EXPECT_EQ(scene.image.height, 32);
}

// Of every kind of file, before anything is computed with them.
TEST(Shot, WhatTheCallerDecidesOutOfRangeIsAUsageError) {
  const ShotFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("shot.toml", test::cube_object);
  const LoadOptions wrong[] = {{.fps = TimeBase{25, 0}},
                               {.fps = TimeBase{0, 1}},
                               {.fps = TimeBase{-25, 1}},
                               {.fps = TimeBase{25, 1'000'001}},
                               {.width = 0},
                               {.width = max_image_size + 1},
                               {.height = -1}};
  for (const char* name : {"a.obj", "shot.toml"})
    for (std::size_t i = 0; i < std::size(wrong); ++i) {
      try {
        load_scene(folder.path(name), wrong[i]);
        ADD_FAILURE() << name << ", option " << i;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage) << error.what();
        EXPECT_EQ(error.place(), folder.path(name));
      }
    }
}

TEST(Shot, HashChangesWithEveryByteOfItAndOfItsFiles) {
  const ShotFolder folder;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", shot = "[[object]]\nmesh = \"a.obj\"\n";
  folder.write("a.obj", triangle);
  const std::string first = folder.load(shot).content_hash;
  EXPECT_EQ(folder.load(shot).content_hash, first);
  EXPECT_NE(folder.load(shot + "#").content_hash, first);
  folder.write("a.obj", triangle + "#");
  EXPECT_NE(folder.load(shot).content_hash, first);
}

TEST(Shot, OfTwentyThousandObjectsKeepsOneMesh) {
  std::string shot = "[camera]\neye = [0, 0, 50]\n";
  for (int i = 0; i < 20'000; ++i)
    shot += "[[object]]\nname = \"cube" + std::to_string(i) +
            "\"\nmesh = \"cube\"\n[[object.transform]]\ntranslate = [" + std::to_string(i % 100) + ", " +
            std::to_string(i / 100) + ", 0]\n";
  const Scene scene = ShotFolder().load(shot);
  EXPECT_EQ(scene.objects.size(), 20'000u);
  EXPECT_EQ(scene.meshes.size(), 1u);
}

}  // namespace
}  // namespace morphcl
