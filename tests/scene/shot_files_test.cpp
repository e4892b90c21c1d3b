// Models from files in a shot.
#include <gtest/gtest.h>

#include <algorithm>

#include "morphcl/error.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

constexpr std::string_view triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr std::string_view high_triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 9 0\nf 1 2 3\n";

// Two nodes, one below the other, that draw the same unlit red triangle with one morph target "up".
constexpr std::string_view two_nodes = R"({
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0, "children": [1], "translation": [1, 0, 0]}, {"mesh": 0, "translation": [0, 1, 0]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 1}], "material": 0}],
            "extras": {"targetNames": ["up"]}, "weights": [0.25]}],
"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}, "extensions": {"KHR_materials_unlit": {}}}],
"extensionsUsed": ["KHR_materials_unlit"],
"accessors": [{"componentType": 5126, "count": 3, "type": "VEC3", "bufferView": 0, "min": [0, 0, 0], "max": [1, 1, 0]},
              {"componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri":
 "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
})";

TEST(ShotFiles, HangBelowTheObjectsNodeWithTheirOwnMaterial) {
  const ShotFolder folder;
  folder.write("models/two.gltf", two_nodes);
  const Scene scene = folder.load(R"(
[[object]]
name = "pair"
mesh = "models/two.gltf"
[[object.transform]]
translate = [10, 0, 0]
)");
  ASSERT_EQ(scene.objects.size(), 2u);
  const FrameState state = evaluate(scene.timeline, 0);
  EXPECT_EQ(state.node_to_world[scene.objects[0].node][3], glm::dvec4(11, 0, 0, 1));
  EXPECT_EQ(state.node_to_world[scene.objects[1].node][3], glm::dvec4(11, 1, 0, 1));
  for (const Object& object : scene.objects) {
    EXPECT_EQ(object.material.shading, Shading::unlit) << object.name;
    EXPECT_EQ(object.material.base_color, glm::dvec4(1, 0, 0, 1)) << object.name;
    EXPECT_EQ(object.name.substr(0, 5), "pair/");
  }
}

TEST(ShotFiles, TakeTheShotsMaterialWhereGiven) {
  const ShotFolder folder;
  folder.write("two.gltf", two_nodes);
  const Scene scene = folder.load("[[object]]\nmesh = \"two.gltf\"\nshading = \"flat\"\ncolor = [0, 1, 0]\n");
  for (const Object& object : scene.objects) {
    EXPECT_EQ(object.material.shading, Shading::flat);
    EXPECT_EQ(object.material.base_color, glm::dvec4(0, 1, 0, 1));
  }
}

TEST(ShotFiles, AreDrivenByOneMorphTrackWhereverTheTargetIs) {
  const ShotFolder folder;
  folder.write("two.gltf", two_nodes);
  const Scene scene = folder.load(R"(
[[object]]
mesh = "two.gltf"
[[object.track]]
target = "morph.up"
keys = [[0, 0], [10, 1]]
[[object]]
mesh = "two.gltf"
)");
  ASSERT_EQ(scene.objects.size(), 4u);
  const auto weight = [&](int object) { return weights_at(scene.objects[object].morph, scene.timeline.time, 5)[0]; };
  EXPECT_EQ(weight(0), 0.5);
  EXPECT_EQ(weight(1), 0.5);
  EXPECT_EQ(weight(2), 0.25) << "the second use of the file keeps the file's weight";
  EXPECT_EQ(scene.objects[0].mesh, scene.objects[2].mesh) << "and shares its mesh";
}

TEST(ShotFiles, ObjTargetsAreNamedByTheirFiles) {
  const ShotFolder folder;
  folder.write("neutral.obj", triangle_obj);
  folder.write("high.obj", high_triangle_obj);
  const Scene scene = folder.load(R"(
[[object]]
mesh = "neutral.obj"
targets = ["high.obj"]
[[object.track]]
target = "morph.high"
keys = [[0, 0], [10, 1]]
[[object]]
mesh = "neutral.obj"
)");
  ASSERT_EQ(scene.meshes.size(), 2u) << "with and without targets they are two meshes";
  ASSERT_EQ(scene.meshes[0].targets.size(), 1u);
  EXPECT_EQ(scene.meshes[0].targets[0].positions[2], glm::vec3(0, 9, 0));
  EXPECT_TRUE(scene.meshes[1].targets.empty());
}

TEST(ShotFiles, KeepTheImportersPlaceOfAnError) {
  const ShotFolder folder;
  folder.write("broken.obj", "v 0 0 0\nv nonsense\n");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"broken.obj\"\n").substr(0, 12), "broken.obj:2");
}

TEST(ShotFiles, OfAModelAloneAreASceneWithAFittedCamera) {
  const ShotFolder folder;
  folder.write("two.gltf", two_nodes);
  const Scene scene = load_scene(folder.path("two.gltf"));
  EXPECT_EQ(scene.name, "two");
  EXPECT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.timeline.lights.size(), 3u);
  EXPECT_EQ(frame_numbers(scene.frames), std::vector<std::int64_t>{0});
  const FrameState state = evaluate(scene.timeline, 0);
  const glm::dvec4 middle = state.camera.world_to_eye * glm::dvec4(1.5, 1, 0, 1);
  EXPECT_LT(middle.z, 0) << "the camera looks at it";
}

TEST(ShotFiles, OfAnyCaseOfExtensionAreModels) {
  const ShotFolder folder;
  folder.write("A.OBJ", triangle_obj);
  EXPECT_EQ(load_scene(folder.path("A.OBJ")).objects.size(), 1u);
}

}  // namespace
}  // namespace morphcl
