#include "host/render/plan/next_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "anim/timeline_at.hpp"
#include "host/render/plan/choose_vertex_form.hpp"
#include "host/render/plan/make_draw.hpp"
#include "host/render/plan/view_volume.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

bool same_form(const VertexAccuracy* a, const VertexAccuracy* b) {
  const VertexAccuracy plain;
  const VertexAccuracy &one = a ? *a : plain, &other = b ? *b : plain;
  return one.form == other.form && one.pivot == other.pivot && one.clip_rest == other.clip_rest;
}

bool same_shape(const DisplacedPositions* a, const DisplacedPositions* b) {
  return a == b || (a && b && a->hash == b->hash);
}

// Whether all vertices are where they were, bit for bit.
bool is_same_place(const Draw& a, const Draw& b) {
  return a.object_to_clip == b.object_to_clip && same_shape(a.displaced.get(), b.displaced.get()) &&
         same_form(a.accuracy.get(), b.accuracy.get()) &&
         std::equal(a.targets.begin(), a.targets.end(), b.targets.begin(), b.targets.end());
}

}  // namespace

void NextFrame::add_to(FramePlan& plan, bool keeps_idle_targets, ElasticShapes& elastic) {
  const std::int64_t tick = tick_of(scene_.timeline.time, plan.frame + 1);
  nodes_.go_to(tick);
  const int eye = node_of(scene_.timeline.camera);
  const CameraState camera =
      evaluate_camera(scene_.timeline.camera, eye < 0 ? glm::dmat4(1.0) : nodes_.to_world(eye), tick);
  const ViewVolume volume = make_view_volume(camera.projection, plan.width, plan.height);
  FramePlan next;  // as far as draws are made from it: no light and no colour
  next.width = plan.width;
  next.height = plan.height;
  next.channels = {};
  next.camera = volume.camera;
  plan.next_draws.reserve(plan.draws.size());
  for (Draw& draw : plan.draws) {
    const Object& object = scene_.objects[draw.object];
    const glm::dmat4 object_to_world = nodes_.to_world(object.node),
                     object_to_eye = camera.world_to_eye * object_to_world;
    const std::vector<double>& weights = weights_.of(draw.object, tick);
    Draw& moved = plan.next_draws.emplace_back();
    try {
      make_draw({scene_, next, opaque_, ids_, false, tick}, draw.object, object_to_eye,
                volume.eye_to_clip * object_to_eye, moved);
      set_targets(weights, keeps_idle_targets, moved);
      if (draw.displaced)
        moved.displaced = elastic.at(draw.object, plan.frame + 1);
      else if (scene_.accuracy_pixels > 0)
        choose_vertex_form({volume.eye_to_clip, camera.world_to_eye, object_to_world,
                            meshes_[static_cast<std::size_t>(object.mesh)], weights, scene_.accuracy_pixels},
                           next, moved);
    } catch (const Error& error) {
      throw Error(ErrorKind::bad_input, "",
                  fmt::format("object \"{}\" in the next frame, for velocity: {}", object.name, error.message()));
    }
    draw.moves = !is_same_place(draw, moved);
  }
}

}  // namespace morphcl
