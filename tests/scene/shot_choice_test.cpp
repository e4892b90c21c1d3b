// What is chosen out of a model, by a shot or by the caller; and what is odd about a scene as a whole.
#include <gtest/gtest.h>

#include "morphcl/error.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

// Two clips that move the same node, two scenes, two cameras: the second in a node that the clips move.
constexpr std::string_view choices = R"({
"asset": {"version": "2.0"}, "scenes": [{"name": "stage", "nodes": [0, 1, 2]}, {"name": "backstage"}],
"nodes": [{"mesh": 0}, {"camera": 0}, {"camera": 1, "translation": [0, 0, 5]}],
"cameras": [{"name": "wide", "type": "perspective", "perspective": {"yfov": 1, "znear": 1, "aspectRatio": 2}},
            {"name": "close", "type": "perspective", "perspective": {"yfov": 0.5, "znear": 1, "aspectRatio": 2}}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"animations": [
 {"name": "in", "samplers": [{"input": 1, "output": 0}],
  "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}]},
 {"name": "out", "samplers": [{"input": 1, "output": 0}],
  "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}},
               {"sampler": 0, "target": {"node": 0, "path": "scale"}}]}],
"accessors": [{"componentType": 5126, "count": 3, "type": "VEC3", "bufferView": 0},
              {"componentType": 5126, "count": 3, "type": "SCALAR", "bufferView": 1}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12}],
"buffers": [{"byteLength": 48, "uri": "data:application/octet-stream;base64,)"
                                     R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAABA"}]
})";

class Choices : public ::testing::Test {
 protected:
  Choices() { folder.write("model.gltf", choices); }
  Scene model(const LoadOptions& options) { return load_scene(folder.path("model.gltf"), options); }
  ShotFolder folder;
};

bool moves(const Scene& scene, std::size_t node) { return !scene.timeline.nodes[node].scale_track.empty(); }

TEST_F(Choices, OfAModelTheCallerMakes) {
  EXPECT_FALSE(moves(model({}), 0));
  LoadOptions options;
  options.animation = "out";
  options.camera = "close";
  const Scene scene = model(options);
  EXPECT_TRUE(moves(scene, 0));
  EXPECT_EQ(scene.timeline.camera.node, 2);
  EXPECT_EQ(scene.frames[0].last, 50);
  EXPECT_EQ(scene.parts.size(), 6u);
  options = {};
  options.scene = "1";
  const Scene empty = model(options);
  EXPECT_TRUE(empty.objects.empty());
  ASSERT_EQ(empty.warnings.size(), 2u) << "several clips, nothing to draw";
  EXPECT_EQ(empty.warnings.back(),
            "there is nothing to draw; the model has other scenes, by --scene or scene in a shot's object: 0 'stage'");
}

TEST_F(Choices, OfAShotTheShotMakes) {
  LoadOptions options;
  options.animation = "out";
  EXPECT_NE(
      folder.refusal(test::cube_object, options).find("--animation chooses from a glTF model; a shot says so itself"),
      std::string::npos);
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THROW(load_scene(folder.path("a.obj"), options), Error);

  EXPECT_FALSE(moves(folder.load("[[object]]\nmesh = \"model.gltf\"\n"), 1));
  for (const std::string wanted : {"\"out\"", "1", "\"1\""})
    EXPECT_TRUE(moves(folder.load("[[object]]\nmesh = \"model.gltf\"\nanimation = " + wanted + "\n"), 1)) << wanted;
  EXPECT_TRUE(folder.load("[[object]]\nmesh = \"model.gltf\"\nscene = \"backstage\"\n").objects.empty());
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"model.gltf\"\nanimation = \"up\"\n"),
            "shot.toml:1:1: there is no animation 'up'; the file has 0 'in', 1 'out'");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"cube\"\nscene = 0\n"),
            "shot.toml:3:9: scene belongs to a glTF file, not to a built-in solid");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"a.obj\"\nanimation = 0\n"),
            "shot.toml:3:13: animation belongs to a glTF file; an .obj has none");
  // Objects that ask for different clips do not share a model.
  const Scene both = folder.load(
      "[[object]]\nname = \"a\"\nmesh = \"model.gltf\"\n[[object]]\nname = \"b\"\nmesh = \"model.gltf\"\nanimation = "
      "1\n");
  EXPECT_FALSE(moves(both, 1));
  EXPECT_TRUE(moves(both, 5));
}

TEST_F(Choices, OfACameraOutOfAModel) {
  const std::string cube(test::cube_object);
  const Scene scene = folder.load("[camera]\nmodel = \"model.gltf\"\nname = \"close\"\n" + cube);
  ASSERT_EQ(scene.timeline.nodes.size(), 5u) << "three of the model, two of the cube";
  EXPECT_EQ(scene.timeline.camera.node, 2);
  EXPECT_FALSE(scene.timeline.nodes[2].translation_track.empty());
  EXPECT_EQ(scene.objects.size(), 1u);
  EXPECT_TRUE(scene.warnings.empty());
  // 1920 x 1080 is narrower than 2: the authored width stays.
  EXPECT_TRUE(std::holds_alternative<HorizontalPerspective>(scene.timeline.camera.projection));
  EXPECT_EQ(folder.refusal("[camera]\nmodel = \"model.gltf\"\nname = \"far\"\n" + cube),
            "shot.toml:1:1: there is no camera 'far'; the file has 0 'wide', 1 'close'");
  EXPECT_EQ(folder.refusal("[camera]\nmodel = \"model.gltf\"\nnear = 1\n" + cube),
            "shot.toml:3:8: near is the model's own where a camera is taken out of one");
  EXPECT_EQ(folder.refusal("[camera]\nname = \"close\"\n" + cube),
            "shot.toml:2:8: name belongs to a camera out of a model");
  EXPECT_EQ(folder.refusal("[camera]\nmodel = \"model.obj\"\n" + cube),
            "shot.toml:2:9: model \"model.obj\" is not a .gltf or .glb file, which may hold cameras");
}

// tan(w / 2) = aspect tan(h / 2), in all of the image's proportions.
TEST_F(Choices, WhatAnAuthoredCameraShowsStaysInThePicture) {
  LoadOptions options;
  options.width = 300;
  options.height = 100;
  EXPECT_TRUE(std::holds_alternative<Perspective>(model(options).timeline.camera.projection))
      << "wider: more at the sides";
  options.width = 200;
  EXPECT_TRUE(std::holds_alternative<Perspective>(model(options).timeline.camera.projection));
  options.width = 50;
  const auto lens = std::get<HorizontalPerspective>(model(options).timeline.camera.projection);
  // 2 atan(2 tan(1 / 2)) in degrees, to 17 digits by arithmetic of 50.
  EXPECT_NEAR(lens.fovx_degrees, 95.067764815978729, 1e-12);
  EXPECT_EQ(lens.near, 1);
}

TEST(SceneOddities, AnObjectOfAlphaZeroIsNotDrawn) {
  const ShotFolder folder;
  const Scene gone = folder.load("[[object]]\nmesh = \"cube\"\ncolor = [1, 0, 0, 0]\n");
  EXPECT_TRUE(gone.objects.empty());
  EXPECT_EQ(gone.warnings, std::vector<std::string>{"there is nothing to draw"});
  const Scene faint = folder.load("[[object]]\nmesh = \"cube\"\ncolor = [1, 0, 0, 0.5]\n");
  EXPECT_EQ(faint.objects.size(), 1u);
  EXPECT_EQ(faint.objects[0].material.base_color.a, 0.5);
  EXPECT_TRUE(faint.warnings.empty());
}

TEST(SceneOddities, AnUpAlongTheViewIsReplacedAndNamed) {
  const ShotFolder folder;
  const std::string cube(test::cube_object);
  EXPECT_EQ(folder.load("[camera]\neye = [0, 5, 0]\n" + cube).warnings,
            std::vector<std::string>{"camera: at frame 0 up lies along the view; (1, 0, 0) is used"});
  EXPECT_TRUE(folder.load("[camera]\neye = [0, 5, 0.01]\n" + cube).warnings.empty());
  const Scene passing = folder.load(
      "[frames]\nrange = \"0-20\"\n[camera]\neye = [0, 5, 5]\n[[camera.track]]\ntarget = \"eye\"\n"
      "keys = [[0, [0, 5, 5]], [10, [0, 5, 0]], [20, [0, 5, -5]]]\n" +
      cube);
  ASSERT_EQ(passing.warnings.size(), 1u);
  EXPECT_NE(passing.warnings[0].find("at frame 10 up lies along the view"), std::string::npos);
}

}  // namespace
}  // namespace morphcl
