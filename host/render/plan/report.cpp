#include "host/render/plan/report.hpp"

#include <fmt/format.h>

#include "anim/node_sampler.hpp"
#include "anim/timeline_at.hpp"
#include "host/render/plan/single_cover.hpp"

namespace morphcl {

namespace {

std::string plural(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

struct Counts {
  std::size_t hidden = 0, empty = 0, outside = 0;
  std::size_t used_targets = 0, idle_targets = 0;  // of the draws, by weight
};

Counts count(const Scene& scene, const FramePlan& plan) {
  Counts counts;
  NodeSampler nodes(scene.timeline.nodes);
  nodes.go_to(tick_of(scene.timeline, plan.frame));
  for (const Object& object : scene.objects)
    if (!has_primitives(object, scene.meshes[object.mesh]))
      ++counts.empty;
    else if (!nodes.is_visible(object.node))
      ++counts.hidden;
  counts.outside = scene.objects.size() - counts.empty - counts.hidden - plan.draws.size();
  for (const Draw& draw : plan.draws) {
    std::size_t used = 0;
    for (const ActiveTarget& target : draw.targets) used += target.weight != 0.0f;
    counts.used_targets += used;
    counts.idle_targets += draw.mesh->targets.size() - used;
  }
  return counts;
}

class Notes {
 public:
  Notes(const Scene& scene, const PlanOptions& options, const FramePlan& plan)
      : scene_(scene), options_(options), plan_(plan), counts_(count(scene, plan)) {}

  std::vector<PlanNote> take() {
    channels();
    objects();
    targets();
    shading();
    stages();
    return std::move(notes_);
  }

 private:
  void note(std::string item, bool done, std::string reason) {
    notes_.push_back({std::move(item), done, std::move(reason)});
  }
  // What could be left out: it is done where the options say so.
  void note_idle(std::string item, bool may_leave_out, std::string reason) {
    const bool done = !options_.leave_out || !may_leave_out;
    note(std::move(item), done, done ? reason + "; nothing is to be left out" : reason);
  }

  void channels() {
    note("RGBA", plan_.color, plan_.color ? "asked for" : "not among the channels");
    note("Z", plan_.depth, plan_.depth ? "asked for" : "not among the channels");
  }

  void objects() {
    note("objects", !plan_.draws.empty(), fmt::format("{} of {} drawn", plan_.draws.size(), scene_.objects.size()));
    if (counts_.outside)
      note("objects out of view", false, plural(counts_.outside, "object") + ": their bounds miss the view");
    if (counts_.hidden) note("hidden objects", false, plural(counts_.hidden, "object"));
    if (counts_.empty) note("empty objects", false, plural(counts_.empty, "object") + " without anything to draw");
  }

  void targets() {
    note("morph targets", counts_.used_targets > 0,
         counts_.used_targets > 0 ? plural(counts_.used_targets, "active target") : "no weight differs from 0");
    if (counts_.idle_targets)
      note_idle("idle morph targets", options_.idle_targets, plural(counts_.idle_targets, "target") + " of weight 0");
  }

  void shading() {
    bool smooth = false, flat = false, tinted = false, lines = false;
    for (const Draw& draw : plan_.draws) {
      smooth |= draw.shading == Shading::smooth, flat |= draw.shading == Shading::flat;
      lines |= draw.shading == Shading::wireframe, tinted |= draw.vertex_colors;
    }
    const bool lit = smooth || flat;
    note("lights", !plan_.lights.empty() && lit,
         plan_.lights.empty() ? "no light in the scene: ambient light is part of the colour"
         : lit                ? plural(plan_.lights.size(), "light")
                              : "nothing that is lit");
    note("vertex normals", smooth, smooth ? "smooth shading" : "no smooth shading");
    note("face light", flat, flat ? "flat shading: once a face" : "no flat shading");
    note("vertex colours", tinted, tinted ? "the mesh has them" : "no mesh has them");
    note("lines", lines, lines ? "wireframe shading" : "no wireframe shading");
    note("blending", false, "surfaces are opaque: the nearest one shows");
  }

  void stages() {
    note("clipping", plan_.clips,
         !plan_.clips                              ? "nothing comes near a clip plane"
         : options_.leave_out && options_.clipping ? "something may touch the near plane or the guard band"
                                                   : "nothing is to be left out");
    note("perspective divide", plan_.divides,
         !plan_.divides   ? "orthographic: w is 1"
         : plan_.parallel ? "orthographic: w is 1; nothing is to be left out"
                          : "perspective");
    note("depth test", plan_.tests_depth,
         plan_.tests_depth           ? "triangles may lie behind others"
         : has_convex_outline(plan_) ? "no pixel is covered twice: front faces within a convex outline"
                                     : "no pixel is covered twice: front faces within a star-shaped outline");
  }

  const Scene& scene_;
  const PlanOptions& options_;
  const FramePlan& plan_;
  const Counts counts_;
  std::vector<PlanNote> notes_;
};

}  // namespace

PlanReport explain(const Planner& planner, const Scene& scene, const PlanOptions& options, std::int64_t frame) {
  PlanReport report{planner.plan(frame), {}};
  report.notes = Notes(scene, options, report.plan).take();
  return report;
}

}  // namespace morphcl
