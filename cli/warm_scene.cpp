#include "cli/warm_scene.hpp"

namespace morphcl::cli {

namespace {
constexpr int side = 64;  // pixels: one tile

enum class Reach { in_view, through_near_plane };

// Two triangles that cross the frame, with one target of each form.
Mesh small_mesh(Reach reach) {
  Mesh mesh;
  mesh.name = "warm";
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, reach == Reach::in_view ? 1 : 8}};
  mesh.normals.assign(4, glm::vec3(0, 0, 1));
  mesh.colors.assign(4, glm::vec4(1));
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  MorphTarget delta;
  delta.name = "delta";
  delta.positions.assign(4, glm::vec3(0, 0.1f, 0));
  delta.normals.assign(4, glm::vec3(0.1f, 0, 0));
  delta.colors.assign(4, glm::vec4(0));
  MorphTarget absolute = delta;
  absolute.name = "absolute";
  absolute.form = TargetForm::absolute;
  absolute.positions = mesh.positions;
  absolute.normals = mesh.normals;
  absolute.colors = mesh.colors;
  mesh.targets = {delta, absolute};
  return mesh;
}

Scene scene_with(const Projection& projection, Reach reach, ChannelSet channels, const std::vector<Shading>& shadings) {
  Scene scene;
  scene.name = "warm";
  scene.image.width = scene.image.height = side;
  scene.image.channels = channels;
  scene.meshes = {small_mesh(reach)};
  scene.timeline.nodes = {Node{}};
  scene.timeline.camera.projection = projection;
  Light point;
  point.kind = LightKind::point;
  point.falloff = true;
  scene.timeline.lights = {Light{}, point};
  for (const Shading shading : shadings) {
    Object object;
    object.name = "object" + std::to_string(scene.objects.size());
    object.material.shading = shading;
    object.material.double_sided = true;
    object.morph.weights = {0.5, 0.25};
    scene.objects.push_back(object);
  }
  scene.frames = {FrameRange{}};
  return scene;
}
}  // namespace

std::vector<Scene> warm_scenes() {
  const std::vector<Shading> all = {Shading::flat, Shading::smooth, Shading::unlit, Shading::wireframe};
  // Stages share launches in small frames, where nothing is clipped and where nothing is flat.
  return {scene_with(Perspective{}, Reach::through_near_plane, default_channels, all),
          scene_with(Perspective{}, Reach::through_near_plane, {Channel::depth}, {Shading::smooth}),
          scene_with(Orthographic{}, Reach::in_view, {Channel::color}, all),
          scene_with(Orthographic{}, Reach::in_view, {Channel::normal, Channel::velocity}, all)};
}

}  // namespace morphcl::cli
