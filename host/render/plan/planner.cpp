#include "morphcl/planner.hpp"
#include "host/render/frame/channel_passes.hpp"
#include "host/render/frame/frame_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "anim/node_sampler.hpp"
#include "anim/timeline_at.hpp"
#include "host/geometry/bounds.hpp"
#include "host/render/plan/choose_vertex_form.hpp"
#include "host/render/plan/draw_ids.hpp"
#include "host/render/plan/draw_memory.hpp"
#include "host/render/plan/elastic_shapes.hpp"
#include "host/render/plan/has_primitives.hpp"
#include "host/render/plan/make_draw.hpp"
#include "host/render/plan/motion_bounds.hpp"
#include "host/render/plan/next_frame.hpp"
#include "host/render/plan/object_tree.hpp"
#include "host/render/plan/shared_weights.hpp"
#include "host/render/plan/single_cover.hpp"
#include "host/render/plan/transparency.hpp"
#include "host/render/plan/view_volume.hpp"
#include "host/scene/model/base_color.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

std::array<float, 3> to_array(const glm::dvec3& v) { return {to_fp32(v.x), to_fp32(v.y), to_fp32(v.z)}; }

PlanOptions without_exceptions(const PlanOptions& options) {
  constexpr bool no = false;
  return options.leave_out ? options : PlanOptions{no, no, no, no, no, no, no, no, no};
}

std::vector<MorphBounds> bounds_of_meshes(const Scene& scene) { return {scene.meshes.begin(), scene.meshes.end()}; }

std::vector<std::optional<BoundedBox>> bounds_over_time(const Scene& scene, const std::vector<MorphBounds>& meshes,
                                                        const NodeSampler& nodes) {
  std::vector<std::optional<BoundedBox>> bounds;
  std::vector<Interval> ranges;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (scene.objects[i].morph.elastic) {
      bounds.push_back(std::nullopt);  // its springs may throw it anywhere
      continue;
    }
    weight_ranges(scene.objects[i].morph, ranges);
    bounds.push_back(bounds_over_time(scene.timeline.nodes, nodes, object.node, meshes[object.mesh].at(ranges)));
  }
  return bounds;
}

// What planning asks of every object that may be in view, side by side in memory.
struct ObjectFacts {
  int mesh, node;
  bool is_seen;      // it has something to draw, and alpha lets some of it show
  bool is_still;     // its node and colour never change and it is no elastic body: only its weights may change
  bool morphs;       // some weight has a track
  bool is_elastic;   // an elastic body
  bool moves_alpha;  // it may be seen now and not then
};

std::vector<ObjectFacts> facts_of_objects(const Scene& scene, const NodeSampler& nodes,
                                          const std::vector<bool>& vertex_alpha) {
  std::vector<ObjectFacts> facts;
  facts.reserve(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const MorphWeights& weights = scene.objects[i].morph;
    const bool morphs = !weights.tracks.empty();
    // Weights decide how accurate vertices have to be.
    const Material& material = object.material;
    const bool only_weights_change =
        !weights.elastic && !(morphs && scene.accuracy_pixels > 0) && material.base_color_track.empty();
    const bool fades = moves_alpha(material);
    const bool is_seen = has_primitives(object, scene.meshes[object.mesh]) &&
                         (fades || transparency_of(material, material.base_color.a, vertex_alpha[object.mesh],
                                                   scene.image.channels) != Transparency::whole);
    facts.push_back({object.mesh, object.node, is_seen, nodes.is_still(object.node) && only_weights_change, morphs,
                     weights.elastic.has_value(), fades});
  }
  return facts;
}

BoundedBox bounded(const Box& box) {
  return {box.center(), 0.5 * box.upper - 0.5 * box.lower, glm::max(glm::abs(box.lower), glm::abs(box.upper))};
}

// Parallel projections have the last row 0 0 0 1: w is exactly 1 at every vertex.
bool divides_by_w(const Draw& draw) { return draw.object_to_clip[3] != Row{0.0f, 0.0f, 0.0f, 1.0f}; }

bool same_targets(const ActiveTargets& a, const ActiveTargets& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ActiveTarget& x, const ActiveTarget& y) { return x.target == y.target; });
}

void add_camera(const ViewVolume& volume, const glm::dmat4& world_to_eye, FramePlan& plan) {
  CameraConstants& camera = plan.camera;
  camera = volume.camera;
  // x_ndc = (P00 x + P02 z + P03) / w, and z = -d: solved for the eye's x at distance d. P02 is a shift of the window
  // in perspective, the slant of the projectors in parallel projections.
  const glm::dmat4& ndc = volume.eye_to_ndc;
  const auto ray = [&](int axis, double pixel_scale, double pixel_offset, int at) {
    const double shift = camera.parallel ? -ndc[3][axis] : ndc[2][axis];
    camera.ray[at] = to_fp32(pixel_scale / ndc[axis][axis]);
    camera.ray[at + 1] = to_fp32((pixel_offset + shift) / ndc[axis][axis]);
    if (camera.parallel) camera.slant[axis] = to_fp32(ndc[2][axis] / ndc[axis][axis]);
  };
  ray(0, 2.0 / plan.width, -1.0, 0);
  ray(1, -2.0 / plan.height, 1.0, 2);
  plan.world_to_eye = world_to_eye;
  plan.world_to_ndc = ndc * world_to_eye;
  if (!plan.has(Channel::normal) && !plan.has(Channel::position)) return;
  const glm::dmat4 eye_to_world = rigid_inverse(world_to_eye);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      plan.eye_to_world[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          to_fp32(eye_to_world[column][row]);
}

// The colours at the rows' middles, in binary64, rounded to half once; null where colour or a background is not there.
std::shared_ptr<const std::vector<BackgroundRow>> background_rows(const ImageSettings& image) {
  if (!image.background || !image.has_color()) return nullptr;
  const auto& [top, bottom] = *image.background;
  auto rows = std::make_shared<std::vector<BackgroundRow>>();
  for (int y = 0; y < image.height; ++y) {
    const double below = (y + 0.5) / image.height;
    BackgroundRow& row = rows->emplace_back();
    for (int c = 0; c < 3; ++c)
      row[static_cast<std::size_t>(c)] = to_half(top[c] == bottom[c] ? top[c] : top[c] + below * (bottom[c] - top[c]));
    row[3] = to_half(1.0);
  }
  return rows;
}

// How far a line's pixels may lie from it: not at all where each column has one, else by less than 0.71 of its width.
double margin_of_lines(const Scene& scene) {
  double margin = 0;
  for (const Object& object : scene.objects)
    if (object.material.shading == Shading::wireframe && (scene.image.samples > 1 || object.material.line_width != 1))
      margin = std::max(margin, 0.75 * object.material.line_width + 1);
  return margin;
}

const Scene& valid(const Scene& scene) {
  try {
    validate(scene);
  } catch (const Error& error) {
    throw Error(ErrorKind::usage, error.place(), error.message());
  }
  return scene;
}

}  // namespace

struct Planner::Impl {
  Impl(const Scene& s, const PlanOptions& o)
      : scene(s),
        options(without_exceptions(o)),
        meshes(bounds_of_meshes(s)),
        nodes(s.timeline.nodes),
        tree(bounds_over_time(s, meshes, nodes)),
        vertex_alpha(meshes_with_alpha(s)),
        facts(facts_of_objects(s, nodes, vertex_alpha)),
        ids(s),
        manifests(cryptomatte_manifests(s)),
        background(background_rows(s.image)),
        margin(margin_of_lines(s)),
        weights(s),
        elastic(s) {
    if (s.image.channels.contains(Channel::velocity)) next.emplace(s, meshes, ids);
  }

  FramePlan plan(std::int64_t frame);

  const Scene& scene;
  const PlanOptions options;

 private:
  ViewVolume start(std::int64_t frame, FramePlan& plan);
  void add_light(const LightState& light, FramePlan& plan) const;
  void add_draws(const ViewVolume& volume, FramePlan& plan);
  void add_draw(std::size_t object, const ViewVolume& volume, FramePlan& plan);
  bool has_faded(const Object& object) const;  // nothing of it shows at the tick
  std::shared_ptr<const DisplacedPositions> displaced_positions(std::size_t object, std::int64_t frame);

  static std::uint64_t next_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }

  const std::vector<MorphBounds> meshes;
  const std::uint64_t number = next_number();

  std::mutex mutex;  // of what follows: room that every frame uses again
  NodeSampler nodes;
  const ObjectTree tree;
  const std::vector<bool> vertex_alpha;  // of each mesh
  const std::vector<ObjectFacts> facts;
  const DrawIds ids;
  const std::shared_ptr<const CryptomatteManifests> manifests;
  const std::shared_ptr<const std::vector<BackgroundRow>> background;
  const double margin;         // around the picture, pixels
  ObjectTree::InView in_view;  // of the last frame's view
  DrawMemory memory;
  SharedWeights weights;
  ElasticShapes elastic;
  std::optional<NextFrame> next;  // where velocity is asked for
  std::size_t drawn_before = 0;
  std::int64_t tick = 0;
};

void Planner::Impl::add_light(const LightState& light, FramePlan& plan) const {
  if (light.color == glm::dvec3(0.0)) return;
  const double point = light.kind == LightKind::point ? 1.0 : 0.0;
  EyeLight& eye_light = plan.lights.emplace_back(
      EyeLight{light.kind, to_array(glm::dvec3(plan.world_to_eye * glm::dvec4(light.vector, point))),
               to_array(light.color), light.falloff});
  if (!light.spot) return;
  const double inner = sin_cos_degrees(light.spot->inner_cone_degrees).cos,
               outer = sin_cos_degrees(light.spot->outer_cone_degrees).cos;
  eye_light.beam = to_array(glm::dmat3(plan.world_to_eye) * light.spot->beam);
  eye_light.cone_scale = to_fp32(1 / (inner - outer));
  eye_light.cone_offset = to_fp32(-outer / (inner - outer));
}

ViewVolume Planner::Impl::start(std::int64_t frame, FramePlan& plan) {
  const Timeline& timeline = scene.timeline;
  nodes.go_to(tick);
  plan.planner = number;
  plan.frame = frame;
  plan.fps_numerator = timeline.time.fps_numerator;
  plan.fps_denominator = timeline.time.fps_denominator;
  plan.width = scene.image.width;
  plan.height = scene.image.height;
  plan.channels = scene.image.channels;
  plan.channel_names = scene.image.channel_names;
  plan.manifests = manifests;
  const bool needs_samples = plan.has_color() || !(plan.channels & channels_of_samples).empty();
  plan.samples = needs_samples ? scene.image.samples : 1;
  const auto to_world = [this](int node) { return node < 0 ? glm::dmat4(1.0) : nodes.to_world(node); };
  const CameraState camera = evaluate_camera(timeline.camera, to_world(node_of(timeline.camera)), tick);
  const ViewVolume volume = make_view_volume(camera.projection, plan.width, plan.height, margin);
  add_camera(volume, camera.world_to_eye, plan);
  plan.depth_format = scene.image.depth_format;
  plan.visibility = scene.image.visibility;
  set_depth_buffer(plan.depth_format, far_distance(camera.projection), plan.camera);
  plan.ambient = to_array(timeline.ambient);
  for (std::size_t i = 0; i < timeline.lights.size(); ++i) {
    const LightState light = evaluate_light(timeline.lights[i], i, to_world(timeline.lights[i].node), tick);
    if (plan.has_color() || !options.normals) add_light(light, plan);
  }
  plan.keeps_vertices = options.kept_vertices;
  plan.keeps_blank_tiles = options.blank_tiles;
  plan.background = background;
  return volume;
}

bool Planner::Impl::has_faded(const Object& object) const {
  const double alpha = base_color_at(object.material, tick).a;
  return transparency_of(object.material, alpha, vertex_alpha[object.mesh], scene.image.channels) ==
         Transparency::whole;
}

void Planner::Impl::add_draw(std::size_t object_index, const ViewVolume& volume, FramePlan& plan) {
  const ObjectFacts& object = facts[object_index];
  if (!object.is_seen || !nodes.is_visible(object.node)) return;
  if (object.moves_alpha && has_faded(scene.objects[object_index])) return;
  const bool inside = in_view.inside.contains(object_index);
  const Draw* before = object.is_still ? memory.find(static_cast<std::uint32_t>(object_index)) : nullptr;
  const std::vector<double>& targets = weights.of(object_index, tick);
  glm::dmat4 object_to_eye, object_to_clip;
  if (!before || !inside) {
    object_to_eye = plan.world_to_eye * nodes.to_world(object.node);
    object_to_clip = volume.eye_to_clip * object_to_eye;
  }
  const auto displaced = object.is_elastic ? displaced_positions(object_index, plan.frame) : nullptr;
  // What is inside the view at all times is so now, and what is inside the view is inside the guard band.
  if (!inside) {
    const BoundedBox box = bounded(displaced ? displaced->box : meshes[object.mesh].at(targets));
    if (options.objects_out_of_view && HalfSpaces(volume.view, object_to_clip).side(box) == Side::outside) return;
    plan.clips = plan.clips || HalfSpaces(volume.clip, object_to_clip).side(box) != Side::inside;
  }
  try {
    Draw& draw = before ? plan.draws.emplace_back(*before) : plan.draws.emplace_back();
    if (!before)
      make_draw({scene, plan, vertex_alpha, ids, !options.normals, tick}, object_index, object_to_eye, object_to_clip,
                draw);
    if (!before || object.morphs) set_targets(targets, !options.idle_targets, draw);
    if (object.is_still && !(before && same_targets(draw.targets, before->targets))) memory.replace();
    draw.displaced = displaced;
    if (!before && !displaced && scene.accuracy_pixels > 0)
      choose_vertex_form({volume.eye_to_clip, plan.world_to_eye, nodes.to_world(object.node), meshes[object.mesh],
                          targets, scene.accuracy_pixels},
                         plan, draw);
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_input, "",
                fmt::format("object \"{}\": {}", scene.objects[object_index].name, error.message()));
  }
}

std::shared_ptr<const DisplacedPositions> Planner::Impl::displaced_positions(std::size_t object, std::int64_t frame) {
  try {
    return elastic.at(object, frame);
  } catch (const Error& error) {
    throw Error(ErrorKind::bad_input, "",
                fmt::format("object \"{}\": {}", scene.objects[object].name, error.message()));
  }
}

void Planner::Impl::add_draws(const ViewVolume& volume, FramePlan& plan) {
  plan.clips = !options.clipping;
  const bool same_view = memory.look({plan.world_to_eye, volume.eye_to_clip, !plan.lights.empty()});
  plan.draws.reserve(drawn_before);
  if (options.objects_out_of_view) {
    if (!same_view) tree.find(HalfSpaces(volume.view, volume.eye_to_clip * plan.world_to_eye), in_view);
    in_view.candidates.for_each([&](std::size_t object) { add_draw(object, volume, plan); });
  } else {
    in_view.inside.clear(scene.objects.size());
    for (std::size_t object = 0; object < scene.objects.size(); ++object) add_draw(object, volume, plan);
  }
  plan.draws_version = memory.remember(plan.draws, [this](const Draw& draw) { return facts[draw.object].is_still; });
  drawn_before = plan.draws.size();
}

FramePlan Planner::Impl::plan(std::int64_t frame) {
  const std::lock_guard lock(mutex);
  FramePlan plan;
  tick = tick_of(scene.timeline.time, frame);
  try {
    add_draws(start(frame, plan), plan);
    if (next) next->add_to(plan, !options.idle_targets, elastic);
  } catch (const Error& error) {
    const ErrorKind kind = error.kind() == ErrorKind::usage ? ErrorKind::bad_input : error.kind();
    throw Error(kind, error.place(), fmt::format("frame {}: {}", frame, error.message()));
  }
  plan.divides = !options.divide || std::any_of(plan.draws.begin(), plan.draws.end(), divides_by_w);
  plan.blends = std::any_of(plan.draws.begin(), plan.draws.end(), [](const Draw& draw) { return draw.blended; });
  plan.tests_depth = !options.depth_test || plan.blends || !is_covered_once(plan);
  return plan;
}

Planner::Planner(const Scene& scene, const PlanOptions& options)
    : impl_(std::make_unique<Impl>(valid(scene), options)) {}
Planner::~Planner() = default;
Plan Planner::plan(std::int64_t frame) const { return Plan(impl_->plan(frame)); }
const Scene& Planner::scene() const { return impl_->scene; }
const PlanOptions& Planner::options() const { return impl_->options; }

Plan plan_frame(const Scene& scene, std::int64_t frame, const PlanOptions& options) {
  FramePlan plan = *Planner(scene, options).plan(frame);
  plan.alone = true;
  return Plan(std::move(plan));
}

}  // namespace morphcl
