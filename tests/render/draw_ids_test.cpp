// What plans say of objects and materials for the channels that show them.
#include <gtest/gtest.h>

#include "host/cryptomatte_id.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/plan/draw_ids.hpp"
#include "host/scene/model/material_list.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"

namespace morphcl::test {
namespace {

// Objects 0 and 2 share a material; object 1, whose material has no name, is out of view; 3 has the first one's name.
Scene four_objects() {
  SceneBuilder builder(64, 48);
  for (int i = 0; i < 4; ++i) builder.add(make_cube(), Shading::flat, place({i == 1 ? 1000.0 : 0.2 * i, 0, 0}, 1));
  Scene scene = builder.look({0, 0, 5}).scene();
  const char* const materials[] = {"paint", "", "paint", "glass"};
  for (std::size_t i = 0; i < 4; ++i) scene.objects[i].material.name = materials[i];
  scene.objects[3].name = scene.objects[0].name;
  return scene;
}

TEST(MaterialList, NamesInTheOrderOfTheirFirstUse) {
  const Scene scene = four_objects();
  const MaterialList list = list_materials(scene);
  EXPECT_EQ(list.names, (std::vector<std::string>{"paint", "object 1", "glass"}));
  EXPECT_EQ(list.of_object, (std::vector<std::uint32_t>{0, 1, 0, 2}));
  EXPECT_EQ(material_names(scene), list.names);
  EXPECT_TRUE(material_names(Scene()).empty());
}

TEST(DrawIds, AreThoseOfTheSceneWhateverIsDrawn) {
  Scene scene = four_objects();
  scene.image.channels = every_channel;
  const Plan plan = plan_frame(scene, 0);
  ASSERT_EQ(plan->draws.size(), 3u) << "object 1 is out of view";
  const std::uint32_t objects[] = {1, 3, 4}, materials[] = {1, 1, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    const Draw& draw = plan->draws[i];
    EXPECT_EQ(draw.object_id, objects[i]);
    EXPECT_EQ(draw.material_id, materials[i]);
    EXPECT_EQ(draw.crypto_object, cryptomatte_id(scene.objects[draw.object].name));
    EXPECT_EQ(draw.crypto_material, cryptomatte_id(i < 2 ? "paint" : "glass"));
  }
  EXPECT_EQ(plan->draws[0].crypto_object, plan->draws[2].crypto_object) << "one name, one id";
}

TEST(DrawIds, AreOnlyThereWhereAChannelAsks) {
  Scene scene = four_objects();
  for (const Channel channel : every_channel) {
    scene.image.channels = {channel};
    const Plan plan = plan_frame(scene, 0);
    const Draw& draw = plan->draws[1];
    EXPECT_EQ(draw.object_id != 0, channel == Channel::object_id) << name_of(channel);
    EXPECT_EQ(draw.material_id != 0, channel == Channel::material_id) << name_of(channel);
    EXPECT_EQ(draw.crypto_object != 0, channel == Channel::crypto_object) << name_of(channel);
    EXPECT_EQ(draw.crypto_material != 0, channel == Channel::crypto_material) << name_of(channel);
  }
}

TEST(CryptomatteManifests, NameAllObjectsOfTheSceneForTheFile) {
  Scene scene = four_objects();
  EXPECT_EQ(plan_frame(scene, 0).attributes().manifests, nullptr);
  scene.image.channels.insert(Channel::crypto_material);
  scene.image.channel_names = ChannelNames::blender;
  const FrameAttributes attributes = plan_frame(scene, 0).attributes();
  ASSERT_NE(attributes.manifests, nullptr);
  EXPECT_EQ(attributes.manifests->objects, "");
  EXPECT_TRUE(attributes.manifests->materials.starts_with("{\"paint\":\"")) << attributes.manifests->materials;
  EXPECT_NE(attributes.manifests->materials.find("\"object 1\":\""), std::string::npos) << "also what is out of view";
  EXPECT_EQ(attributes.channel_names, ChannelNames::blender);
}

}  // namespace
}  // namespace morphcl::test
