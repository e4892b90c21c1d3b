#include <fmt/format.h>

#include <algorithm>

#include "anim/node_sampler.hpp"
#include "anim/timeline_at.hpp"
#include "host/render/explain/accuracy_notes.hpp"
#include "host/render/explain/channel_notes.hpp"
#include "host/render/explain/cost_model.hpp"
#include "host/render/explain/earlier_frames.hpp"
#include "host/render/explain/memory_model.hpp"
#include "host/render/explain/visibility_note.hpp"
#include "host/render/frame/channel_passes.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/plan/has_primitives.hpp"
#include "host/render/plan/single_cover.hpp"
#include "host/render/plan/transparency.hpp"
#include "host/scene/model/base_color.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

std::string plural(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

struct Counts {
  std::size_t hidden = 0, empty = 0, transparent = 0, outside = 0;
  std::size_t used_targets = 0, idle_targets = 0;  // of the draws, by weight
};

Counts count(const Scene& scene, const FramePlan& plan) {
  Counts counts;
  NodeSampler nodes(scene.timeline.nodes);
  const std::int64_t tick = tick_of(scene.timeline.time, plan.frame);
  nodes.go_to(tick);
  const std::vector<bool> vertex_alpha = meshes_with_alpha(scene);
  for (const Object& object : scene.objects)
    if (!has_primitives(object, scene.meshes[object.mesh]))
      ++counts.empty;
    else if (transparency_of(object.material, base_color_at(object.material, tick).a,
                             vertex_alpha[static_cast<std::size_t>(object.mesh)], plan.channels) == Transparency::whole)
      ++counts.transparent;
    else if (!nodes.is_visible(object.node))
      ++counts.hidden;
  counts.outside = scene.objects.size() - counts.empty - counts.transparent - counts.hidden - plan.draws.size();
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
  Notes(const Planner& planner, const FramePlan& plan)
      : scene_(planner.scene()),
        planner_(planner),
        options_(planner.options()),
        plan_(plan),
        counts_(count(scene_, plan)),
        reach_(find_reach(plan)),
        work_(count_work(plan, reach_)),
        costs_(estimate_costs(plan, work_, count_skipped(scene_, plan))) {}

  std::vector<PlanNote> take() {
    channels();
    samples();
    objects();
    targets();
    elastic();
    shading();
    stages();
    for (PlanNote& vertices : accuracy_notes(scene_, plan_)) notes_.push_back(std::move(vertices));
    earlier_frames();
    blank_tiles();
    return std::move(notes_);
  }
  double milliseconds() const { return costs_.everything; }

 private:
  void note(std::string item, bool done, std::string reason, double milliseconds) {
    notes_.push_back({std::move(item), done, std::move(reason), milliseconds});
  }
  // What can be left out, unless the options say otherwise.
  void note_idle(std::string item, bool may_leave_out, std::string reason, double milliseconds) {
    if (may_leave_out && options_.leave_out)
      note(std::move(item), false, std::move(reason), milliseconds);
    else
      note(std::move(item), true, std::move(reason) + kept, milliseconds);
  }

  void channels() {
    note("RGBA", plan_.has_color(), reason_of(Channel::color), costs_.color);
    if (plan_.background) note("background", true, "colour of every pixel where nothing is drawn", 0);
    note("Z", plan_.has_depth(), reason_of(Channel::depth), costs_.depth);
    other_channels();
    rounding();
    for (PlanNote& step : channel_steps(plan_, costs_)) notes_.push_back(std::move(step));
  }

  std::string reason_of(Channel channel) const {
    if (!plan_.has(channel)) return "not among the channels";
    const std::string detail = channel_detail(channel, plan_);
    return fmt::format("asked for: {} bytes a pixel{}{}", pixel_bytes(channel), detail.empty() ? "" : "; ", detail);
  }

  // Those that are not asked for in one line: most frames have none of them.
  void other_channels() {
    std::string names;
    for (const Channel channel : every_channel - default_channels)
      if (plan_.has(channel))
        note(std::string(name_of(channel)), true, reason_of(channel),
             costs_.channels[static_cast<std::size_t>(channel)]);
      else
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(channel));
    if (!names.empty()) note("other channels", false, names + ": not among the channels", 0);
  }

  // Of Z, P and N in files. It is done by the threads that write them: the estimate is of drawing.
  void rounding() {
    const ImageSettings& image = scene_.image;
    round_mantissas_of("Z", "z_error", image.z_error);
    round_mantissas_of("P", "p_error", image.p_error);
    if (image.n_error == 0) return;
    const double step = step_for(image.n_error);
    constexpr double min_half = 0x1p-24;
    const bool rounds = step > min_half;
    note("rounding of N", rounds,
         rounds ? fmt::format("n_error is {}: multiples of {} keep it, the bits below would fill files", image.n_error,
                              step)
                : fmt::format("n_error is {}: halves are that fine by themselves", image.n_error),
         0);
  }

  void round_mantissas_of(const char* channel, const char* key, double error) {
    if (error == 0) return;
    const int bits = mantissa_bits_for(error);
    const std::string item = fmt::format("rounding of {}", channel);
    if (bits < float_mantissa_bits)
      note(item, true,
           fmt::format("{} is {}: {} of {} mantissa bits keep it, the others would fill files", key, error, bits,
                       float_mantissa_bits),
           0);
    else
      note(item, false, fmt::format("{} is {}: all {} mantissa bits are needed", key, error, bits), 0);
  }

  void samples() {
    const int asked_for = scene_.image.samples;
    note("samples", plan_.samples > 1,
         asked_for == 1      ? "one a pixel is asked for: its centre"
         : plan_.samples > 1 ? fmt::format("{} a pixel are asked for: {}", asked_for,
                                           plan_.has_color() ? "colour and alpha are their mean" : "shares are theirs")
                             : fmt::format("{} a pixel are asked for, but no colour", asked_for),
         costs_.samples);
    if (plan_.samples > 1)
      note("pixel centres", draws_centres(plan_),
           plan_.has_depth()      ? "Z is that of the centre, which is no sample: one more pass"
           : draws_centres(plan_) ? "some channel is that of the centre, which is no sample: one more pass"
                                  : "no channel is asked for that shows what is at the centre",
           costs_.centres);
  }

  void objects() {
    note("objects", !plan_.draws.empty(), fmt::format("{} of {} drawn", plan_.draws.size(), scene_.objects.size()),
         costs_.draws);
    // The cost of all objects that are not drawn, by their number.
    const double skipped = static_cast<double>(scene_.objects.size() - plan_.draws.size());
    const auto share = [&](std::size_t objects) { return costs_.skipped * static_cast<double>(objects) / skipped; };
    if (counts_.outside)
      note("objects out of view", false, plural(counts_.outside, "object") + ": their bounds miss the view",
           share(counts_.outside));
    if (counts_.hidden) note("hidden objects", false, plural(counts_.hidden, "object"), share(counts_.hidden));
    if (counts_.transparent)
      note("transparent objects", false, plural(counts_.transparent, "object") + " of which alpha shows nothing", 0);
    if (counts_.empty) note("empty objects", false, plural(counts_.empty, "object") + " without anything to draw", 0);
  }

  void targets() {
    note("morph targets", counts_.used_targets > 0,
         counts_.used_targets > 0 ? plural(counts_.used_targets, "active target") : "no weight differs from 0",
         costs_.targets);
    if (counts_.idle_targets)
      note_idle("idle morph targets", options_.idle_targets, plural(counts_.idle_targets, "target") + " of weight 0",
                costs_.idle_targets);
  }

  void elastic() {
    std::size_t objects = 0, modal = 0, masses = 0;
    for (const Draw& draw : plan_.draws)
      if (draw.displaced) {
        ++objects;
        modal += draw.displaced->method == ElasticMethod::modal;
        masses += draw.displaced->masses;
      }
    if (objects == 0) return;
    const std::string how = modal == objects ? "in closed form, mode by mode"
                            : modal == 0     ? "in steps of TR-BDF2, 16 a frame"
                                             : fmt::format("{} mode by mode, the others in steps of TR-BDF2", modal);
    note("elastic vertices", true, fmt::format("{}, {}: {}", plural(objects, "object"), plural(masses, "point"), how),
         costs_.elastic);
  }

  void shading() {
    bool smooth = false, flat = false, tinted = false, lines = false;
    for (const Draw& draw : plan_.draws) {
      smooth |= draw.shading == Shading::smooth;
      flat |= draw.shading == Shading::flat;
      lines |= draw.shading == Shading::wireframe;
      tinted |= draw.vertex_colors;
    }
    const bool lit = smooth || flat;
    const char* const no_color = "no colour is asked for";
    note("lights", !plan_.lights.empty() && lit,
         !plan_.has_color() && !lit ? no_color
         : plan_.lights.empty()     ? "no light in the scene: ambient light is part of the colour"
         : lit                      ? plural(plan_.lights.size(), "light")
                                    : "nothing that is lit",
         costs_.lights);
    note("vertex normals", smooth,
         smooth              ? "smooth shading"
         : plan_.has_color() ? "no smooth shading"
                             : no_color,
         costs_.normals);
    note("face light", flat,
         flat                ? "flat shading: once a face"
         : plan_.has_color() ? "no flat shading"
                             : no_color,
         costs_.face_light);
    note("vertex colours", tinted,
         tinted              ? "the mesh has them"
         : plan_.has_color() ? "no mesh has them"
                             : no_color,
         costs_.colors);
    note("lines", lines, lines ? "wireframe shading" : "no wireframe shading", costs_.lines);
    const auto blended = static_cast<std::size_t>(
        std::count_if(plan_.draws.begin(), plan_.draws.end(), [](const Draw& draw) { return draw.blended; }));
    note("blending", plan_.blends,
         plan_.blends ? plural(blended, "object") + " with alpha below 1: sorted in each sample, from the front"
                      : "surfaces are opaque: the nearest one shows",
         costs_.blending);
  }

  void stages() {
    note("clipping", plan_.clips,
         !plan_.clips                              ? "nothing comes near a clip plane"
         : options_.leave_out && options_.clipping ? "something may touch the near plane or the guard band"
                                                   : std::string("not judged") + kept,
         costs_.clipping);
    note("perspective divide", plan_.divides,
         plan_.camera.parallel ? std::string("parallel projection: w is 1") + (plan_.divides ? kept : "")
                               : "perspective",
         costs_.divide);
    note("depth test", plan_.tests_depth,
         plan_.tests_depth           ? "triangles may lie behind others"
         : has_convex_outline(plan_) ? "no pixel is covered twice: front faces within a convex outline"
                                     : "no pixel is covered twice: front faces within a star-shaped outline",
         costs_.depth_test);
    if (is_forward(plan_.depth_format))
      note("depth buffer", true, fmt::format("{} is asked for", name_of(plan_.depth_format)), costs_.depth_format);
    if (auto method = visibility_note(plan_, work_)) notes_.push_back(std::move(*method));
  }

  void earlier_frames() {
    const std::optional<UnchangedDraws> unchanged = count_unchanged_draws(planner_, plan_);
    if (unchanged && unchanged->count > 0)
      note_idle("unchanged objects", options_.kept_vertices,
                fmt::format("{} of {} as in frame {}: drawn after it, their vertices stay", unchanged->count,
                            plan_.draws.size(), unchanged->frame),
                costs_.vertices * static_cast<double>(unchanged->count) / static_cast<double>(plan_.draws.size()));
    if (const auto equal = find_equal_frame(planner_, plan_))
      note_idle("equal frame", options_.leave_out,
                fmt::format("the picture of frame {}: drawn after it, it is copied", *equal), costs_.everything);
  }

  void blank_tiles() {
    if (plan_.background) return;  // they are written
    const std::size_t tiles = reach_.reached.size(), blank = tiles - reach_.reached_tiles;
    if (blank == 0) return;
    note_idle("blank tiles", options_.blank_tiles,
              fmt::format("{} of {} tiles and {} of {} rows: no object reaches them", blank, tiles, reach_.blank_rows,
                          plan_.height),
              costs_.blank_pixels);
  }

  static constexpr const char* kept = "; nothing is to be left out";

  const Scene& scene_;
  const Planner& planner_;
  const PlanOptions& options_;
  const FramePlan& plan_;
  const Counts counts_;
  const ScreenReach reach_;
  const Workload work_;
  const FrameCosts costs_;
  std::vector<PlanNote> notes_;
};

}  // namespace

PlanReport explain(const Planner& planner, std::int64_t frame) {
  Plan plan = planner.plan(frame);
  Notes notes(planner, *plan);
  std::vector<PlanNote> taken = notes.take();
  const MemoryNeed memory = estimate_memory(*plan);
  return {std::move(plan), std::move(taken), notes.milliseconds(), memory};
}

}  // namespace morphcl
