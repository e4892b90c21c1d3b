#include "morphcl/job.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "morphcl/solids.hpp"
#include "tests/job/fake_renderer.hpp"

namespace morphcl {
namespace {

using job_test::empty_scene;

// A scene made in code with something of every kind in it.
Scene full_scene() {
  Scene scene = empty_scene();
  scene.add_object("solid", make_solid("pyramid_to_cube"));
  scene.morph(0, "cube", Track::linear(scene.timeline.time, {{0, 0.0}, {10, 1.0}}));
  scene.timeline.lights.emplace_back();
  return scene;
}

TEST(Fingerprint, EverythingThatDecidesTheFileChangesIt) {
  std::set<std::string> seen{fingerprint(full_scene())};
  const std::function<void(Scene&)> changes[] = {
      [](Scene& s) { s.content_hash = "other"; },
      [](Scene& s) { s.image.width += 1; },
      [](Scene& s) { s.image.height += 1; },
      [](Scene& s) { s.image.channels.erase(Channel::color); },
      [](Scene& s) { s.image.channels.erase(Channel::depth); },
      [](Scene& s) { s.image.compression = "zip"; },
      [](Scene& s) { s.image.depth_format = DepthFormat::fixed24; },
      [](Scene& s) { s.image.channels.insert(Channel::normal); },
      [](Scene& s) { s.image.channels.insert(Channel::velocity); },
      [](Scene& s) { s.image.channel_names = ChannelNames::nuke; },
      [](Scene& s) { s.image.p_error = 1e-6; },
      [](Scene& s) { s.objects[0].material.base_color.a = 0.5; },
      [](Scene& s) { s.objects[0].material.alpha_mode = AlphaMode::opaque; },
      [](Scene& s) { s.objects[0].material.alpha_mode = AlphaMode::mask; },
      [](Scene& s) {
        s.objects[0].material.alpha_mode = AlphaMode::mask;
        s.objects[0].material.alpha_cutoff = 0.25;
      },
      [](Scene& s) { s.image.n_error = 1e-6; },
      [](Scene& s) { s.image.z_error = 1e-6; },
      [](Scene& s) { s.image.z_error = 1e-5; },
      [](Scene& s) { s.image.samples = 4; },
      [](Scene& s) { s.image.samples = 8; },
      [](Scene& s) { s.objects[0].material.line_width = 2; },
      [](Scene& s) { s.image.background = Background{}; },
      [](Scene& s) { s.image.background = Background{{0, 0, 0}, {0, 0, 1}}; },
      [](Scene& s) { s.image.background = Background{{0, 0, 1}, {0, 0, 0}}; },
      [](Scene& s) { s.accuracy_pixels = 0.01; },
      [](Scene& s) { s.timeline.time.fps_numerator = 24; },
      [](Scene& s) { s.timeline.time.fps_denominator = 2; },
      [](Scene& s) { s.meshes[0].positions[3].y += 1; },
      [](Scene& s) { s.meshes[0].triangles.pop_back(); },
      [](Scene& s) { s.meshes[0].edges.pop_back(); },
      [](Scene& s) { s.meshes[0].colors.resize(s.meshes[0].positions.size()); },
      [](Scene& s) { s.meshes[0].normals.resize(s.meshes[0].positions.size()); },
      [](Scene& s) { s.meshes[0].targets[0].positions[2].x += 1; },
      [](Scene& s) { s.meshes[0].targets[0].form = TargetForm::delta; },
      [](Scene& s) { s.objects[0].mesh = 1; },
      [](Scene& s) { s.objects[0].node = 1; },
      [](Scene& s) { s.objects[0].material.base_color.g = 0.5; },
      [](Scene& s) { s.objects[0].material.shading = Shading::flat; },
      [](Scene& s) { s.objects[0].material.double_sided = true; },
      [](Scene& s) { s.objects[0].morph.weights[0] = 0.5; },
      [](Scene& s) { s.objects[0].morph.elastic = Elastic{}; },
      [](Scene& s) { s.objects[0].morph.elastic = Elastic{.rest = EdgeRest::base}; },
      [](Scene& s) { s.morph(0, "cube", Track::linear(s.timeline.time, {{0, 0.0}, {11, 1.0}})); },
      [](Scene& s) { s.objects[0].morph.tracks[0].track = Track::linear(s.timeline.time, {{0, 0.0}, {10, 0.5}}); },
      [](Scene& s) { s.objects[0].morph.tracks[0].track = Track::step(s.timeline.time, {{0, 0.0}, {10, 1.0}}); },
      [](Scene& s) { s.objects[0].morph.tracks[0].track = s.objects[0].morph.tracks[0].track.on_spring({5, 0.5}); },
      [](Scene& s) { s.objects[0].morph.tracks[0].track = s.objects[0].morph.tracks[0].track.on_spring({5, 0.25}); },
      [](Scene& s) { s.timeline.nodes[0].static_transform[3].x = 1; },
      [](Scene& s) { s.timeline.nodes[0].translation.x = 1; },
      [](Scene& s) { s.timeline.nodes[0].rotation = {0.6, 0.8, 0, 0}; },
      [](Scene& s) { s.timeline.nodes[0].scale.z = 2; },
      [](Scene& s) { s.timeline.nodes[0].visible_track = Track::step(s.timeline.time, {{0, 1.0}, {5, 0.0}}); },
      [](Scene& s) { s.timeline.camera.eye.x = 1; },
      [](Scene& s) { s.timeline.camera.projection = Perspective{.fovy_degrees = 46}; },
      [](Scene& s) { s.timeline.camera.projection = HorizontalPerspective{}; },
      [](Scene& s) { s.timeline.camera.projection = Oblique{}; },
      [](Scene& s) { s.timeline.camera.projection = Oblique{.shear = {0.5, 0}}; },
      [](Scene& s) { s.timeline.camera.fovy_track = Track::linear(s.timeline.time, {{0, 45.0}, {9, 50.0}}); },
      [](Scene& s) { s.timeline.nodes[0].steps.fixed(CompositeTransform()); },
      [](Scene& s) { s.timeline.nodes[0].steps.fixed(CompositeTransform().translate({1, 0, 0})); },
      [](Scene& s) { s.timeline.nodes[0].steps.add_step({StepKind::translate, {1}}); },
      [](Scene& s) { s.timeline.nodes[0].steps.add_step({StepKind::translate, {1}, {}, true}); },
      [](Scene& s) { s.timeline.nodes[0].steps.add_step({StepKind::rotate_x_degrees, {1}}); },
      [](Scene& s) {
        s.timeline.nodes[0].steps.add_step(
            {StepKind::translate, {}, {{0, Track::linear(s.timeline.time, {{0, 0.0}, {9, 1.0}})}}});
      },
      [](Scene& s) {
        s.timeline.nodes[0].steps.add_step(
            {StepKind::translate, {}, {{1, Track::linear(s.timeline.time, {{0, 0.0}, {9, 1.0}})}}});
      },
      [](Scene& s) {
        s.objects[0].material.base_color_track =
            Track::linear(s.timeline.time, std::vector<VectorKey>{{0, glm::dvec3(0)}, {9, glm::dvec3(1)}});
      },
      [](Scene& s) { s.timeline.camera.parent = 0; },
      [](Scene& s) { s.timeline.lights[0].node = 0; },
      [](Scene& s) { s.timeline.lights[0].spot.emplace(); },
      [](Scene& s) { s.timeline.lights[0].spot.emplace().target.x = 1; },
      [](Scene& s) { s.timeline.lights[0].spot.emplace().inner_cone_degrees = 1; },
      [](Scene& s) { s.timeline.lights[0].spot.emplace().outer_cone_degrees = 1; },
      [](Scene& s) { s.timeline.lights[0].color.r = 0.5; },
      [](Scene& s) { s.timeline.lights[0].kind = LightKind::point; },
      [](Scene& s) { s.timeline.ambient.b = 0.5; },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    Scene scene = full_scene();
    changes[i](scene);
    EXPECT_TRUE(seen.insert(fingerprint(scene)).second) << "change " << i;
  }
}

// Only where a channel shows it, so that frames without that channel stay finished.
TEST(Fingerprint, NamesAndTextureCoordinatesCountWhereAChannelShowsThem) {
  const std::function<void(Scene&)> changes[] = {
      [](Scene& s) { s.objects[0].name = "other"; },
      [](Scene& s) { s.objects[0].material.name = "paint"; },
      [](Scene& s) { s.meshes[0].uvs.resize(s.meshes[0].positions.size()); },
  };
  const auto changes_with = [&changes](std::size_t change, ChannelSet channels) {
    Scene before = full_scene(), after = full_scene();
    before.image.channels = after.image.channels = channels;
    changes[change](after);
    return fingerprint(before) != fingerprint(after);
  };
  for (const Channel channel : every_channel) {
    const bool named = channel == Channel::crypto_object;
    const bool of_material = channel == Channel::crypto_material || channel == Channel::material_id;
    EXPECT_EQ(changes_with(0, {channel}), named || of_material)
        << name_of(channel) << ": a material has its object's name";
    EXPECT_EQ(changes_with(1, {channel}), of_material) << name_of(channel);
    EXPECT_EQ(changes_with(2, {channel}), channel == Channel::uv) << name_of(channel);
  }
}

TEST(Fingerprint, NamesAndFrameRangesDoNot) {
  Scene scene = empty_scene();
  scene.name = "other";
  scene.frames = {{1, 7, 2}};
  scene.warnings = {"something"};
  EXPECT_EQ(fingerprint(scene), fingerprint(empty_scene()));
  EXPECT_EQ(fingerprint(scene).size(), 32u);
}

}  // namespace
}  // namespace morphcl
