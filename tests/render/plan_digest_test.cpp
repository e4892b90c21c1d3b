// The digest of a plan changes with everything that decides pixels, and with nothing else.
#include "host/render/frame/plan_digest.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace morphcl {
namespace {

const Mesh meshes[2];

FramePlan some_plan() {
  FramePlan plan;
  plan.width = 64;
  plan.height = 48;
  plan.lights.push_back({LightKind::point, {1, 2, 3}, {1, 1, 1}, false});
  Draw draw;
  draw.mesh = &meshes[0];
  for (Row& row : draw.object_to_clip) row = {1, 2, 3, 4};
  for (Row& row : draw.object_to_eye) row = {5, 6, 7, 8};
  draw.base_color = {1, 0.5f, 0.25f, 1};
  draw.targets.push_back({0, 0.5f, -0.5f});
  plan.draws.push_back(draw);
  draw.base_color[0] = 0.5f;
  plan.draws.push_back(draw);
  return plan;
}

void replace_target(Draw& draw, const ActiveTarget& target) {
  draw.targets = {};
  draw.targets.push_back(target);
}

using Change = std::pair<const char*, std::function<void(FramePlan&)>>;

const std::vector<Change> changes_of_pixels{
    {"width", [](FramePlan& p) { ++p.width; }},
    {"height", [](FramePlan& p) { ++p.height; }},
    {"color", [](FramePlan& p) { p.channels.erase(Channel::color); }},
    {"depth", [](FramePlan& p) { p.channels.erase(Channel::depth); }},
    {"another channel", [](FramePlan& p) { p.channels.insert(Channel::normal); }},
    {"object's number in a channel", [](FramePlan& p) { p.draws[0].object_id = 7; }},
    {"material's number in a channel", [](FramePlan& p) { p.draws[0].material_id = 7; }},
    {"id of the object's name", [](FramePlan& p) { p.draws[0].crypto_object = 7; }},
    {"id of the material's name", [](FramePlan& p) { p.draws[0].crypto_material = 7; }},
    {"albedo", [](FramePlan& p) { p.draws[0].albedo = {1, 0, 0}; }},
    {"source of normals", [](FramePlan& p) { p.draws[0].normals = NormalSource::faces; }},
    {"a draw that moves", [](FramePlan& p) { p.draws[0].moves = true; }},
    {"draws of the next frame", [](FramePlan& p) { p.next_draws = p.draws; }},
    {"samples", [](FramePlan& p) { p.samples = 4; }},
    {"line width", [](FramePlan& p) { p.draws[0].line_width = 512; }},
    {"parallel", [](FramePlan& p) { p.camera.parallel = true; }},
    {"near plane", [](FramePlan& p) { p.camera.near_plane[2] = 1; }},
    {"near_w", [](FramePlan& p) { p.camera.near_w = 2; }},
    {"near_depth", [](FramePlan& p) { p.camera.near_depth = 2; }},
    {"far_depth", [](FramePlan& p) { p.camera.far_depth = 2; }},
    {"near", [](FramePlan& p) { p.camera.near = 2; }},
    {"ray", [](FramePlan& p) { p.camera.ray[3] = 1; }},
    {"depth of the far plane", [](FramePlan& p) { p.camera.depth_far[0] = 1; }},
    {"rest of the depth of the far plane", [](FramePlan& p) { p.camera.depth_far[1] = 1; }},
    {"depth scale", [](FramePlan& p) { p.camera.depth_scale[0] = 1; }},
    {"rest of the depth scale", [](FramePlan& p) { p.camera.depth_scale[1] = 1; }},
    {"depth span", [](FramePlan& p) { p.camera.depth_span = 1; }},
    {"depth format", [](FramePlan& p) { p.depth_format = DepthFormat::fixed24; }},
    {"slant", [](FramePlan& p) { p.camera.slant[1] = 1; }},
    {"ambient", [](FramePlan& p) { p.ambient[1] = 1; }},
    {"no light", [](FramePlan& p) { p.lights.clear(); }},
    {"light's kind", [](FramePlan& p) { p.lights[0].kind = LightKind::directional; }},
    {"light's vector", [](FramePlan& p) { p.lights[0].vector[0] = 0; }},
    {"light's colour", [](FramePlan& p) { p.lights[0].color[2] = 0; }},
    {"light's falloff", [](FramePlan& p) { p.lights[0].falloff = true; }},
    {"one draw less", [](FramePlan& p) { p.draws.pop_back(); }},
    {"draws' order", [](FramePlan& p) { std::swap(p.draws[0], p.draws[1]); }},
    {"mesh", [](FramePlan& p) { p.draws[1].mesh = &meshes[1]; }},
    {"shading", [](FramePlan& p) { p.draws[1].shading = Shading::smooth; }},
    {"double_sided", [](FramePlan& p) { p.draws[0].double_sided = true; }},
    {"mirrored", [](FramePlan& p) { p.draws[0].mirrored = true; }},
    {"object_to_clip", [](FramePlan& p) { p.draws[1].object_to_clip[3][3] = 0; }},
    {"object_to_eye", [](FramePlan& p) { p.draws[1].object_to_eye[2][3] = 0; }},
    {"normal_to_eye", [](FramePlan& p) { p.draws[1].normal_to_eye[2][2] = 1; }},
    {"base colour", [](FramePlan& p) { p.draws[0].base_color[3] = 0; }},
    {"light per pixel", [](FramePlan& p) { p.draws[0].lit_per_pixel = true; }},
    {"vertex colours", [](FramePlan& p) { p.draws[0].vertex_colors = true; }},
    {"target", [](FramePlan& p) { p.draws[1].targets.push_back({1, 1.0f, 0.0f}); }},
    {"target's number", [](FramePlan& p) { replace_target(p.draws[0], {1, 0.5f, -0.5f}); }},
    {"target's weight", [](FramePlan& p) { replace_target(p.draws[0], {0, 1.0f, -0.5f}); }},
    {"target's base weight", [](FramePlan& p) { replace_target(p.draws[0], {0, 0.5f, 1.0f}); }},
    {"rest of the target's weight", [](FramePlan& p) { replace_target(p.draws[0], {0, 0.5f, -0.5f, 1.0f}); }},
    {"vertex form",
     [](FramePlan& p) {
       VertexAccuracy accuracy;
       accuracy.form = VertexForm::pivot;
       p.draws[0].accuracy = std::make_shared<VertexAccuracy>(accuracy);
     }},
    {"pivot",
     [](FramePlan& p) {
       VertexAccuracy accuracy;
       accuracy.form = VertexForm::pivot;
       accuracy.pivot[1] = 1;
       p.draws[0].accuracy = std::make_shared<VertexAccuracy>(accuracy);
     }},
    {"rest of object_to_clip",
     [](FramePlan& p) {
       VertexAccuracy accuracy;
       accuracy.form = VertexForm::two_float;
       accuracy.clip_rest[2][1] = 1;
       p.draws[0].accuracy = std::make_shared<VertexAccuracy>(accuracy);
     }},
    {"displaced positions",
     [](FramePlan& p) {
       DisplacedPositions displaced;
       displaced.hash = {1, 2};
       p.draws[0].displaced = std::make_shared<DisplacedPositions>(displaced);
     }},
    {"other displaced positions",
     [](FramePlan& p) {
       DisplacedPositions displaced;
       displaced.hash = {1, 3};
       p.draws[0].displaced = std::make_shared<DisplacedPositions>(displaced);
     }},
    {"background",
     [](FramePlan& p) { p.background = std::make_shared<std::vector<BackgroundRow>>(48, BackgroundRow{1, 2, 3, 4}); }},
    {"another row of the background",
     [](FramePlan& p) {
       auto rows = std::make_shared<std::vector<BackgroundRow>>(48, BackgroundRow{1, 2, 3, 4});
       (*rows)[47][2] = 0;
       p.background = rows;
     }},
    {"sign of zero", [](FramePlan& p) { p.ambient[0] = -0.0f; }},
};

const std::vector<Change> changes_of_the_rest{
    {"frame", [](FramePlan& p) { p.frame = 9; }},
    {"world_to_eye", [](FramePlan& p) { p.world_to_eye[3][0] = 9; }},
    {"world_to_ndc", [](FramePlan& p) { p.world_to_ndc[3][0] = 9; }},
    {"clips", [](FramePlan& p) { p.clips = !p.clips; }},
    {"keeps_vertices", [](FramePlan& p) { p.keeps_vertices = !p.keeps_vertices; }},
    {"keeps_blank_tiles", [](FramePlan& p) { p.keeps_blank_tiles = !p.keeps_blank_tiles; }},
};

TEST(PlanDigest, ChangesWithEverythingThatDecidesPixels) {
  std::vector<PlanDigest> seen{pixel_digest(some_plan())};
  for (const auto& [what, change] : changes_of_pixels) {
    FramePlan plan = some_plan();
    change(plan);
    const PlanDigest digest = pixel_digest(plan);
    for (const PlanDigest& other : seen) EXPECT_FALSE(digest == other) << what;
    seen.push_back(digest);
  }
}

TEST(PlanDigest, DoesNotChangeWithTheRest) {
  EXPECT_EQ(pixel_digest(some_plan()), pixel_digest(some_plan()));
  for (const auto& [what, change] : changes_of_the_rest) {
    FramePlan plan = some_plan();
    change(plan);
    EXPECT_EQ(pixel_digest(plan), pixel_digest(some_plan())) << what;
  }
}

}  // namespace
}  // namespace morphcl
