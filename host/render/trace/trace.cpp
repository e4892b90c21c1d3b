#include "morphcl/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "anim/timeline_at.hpp"
#include "host/math/finite.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/trace/model_steps.hpp"
#include "host/render/trace/morphed_point.hpp"
#include "host/render/trace/plane_steps.hpp"
#include "host/render/trace/rendered_point.hpp"
#include "host/render/trace/stages.hpp"
#include "host/render/trace/trace_object.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"

namespace morphcl {

namespace {

constexpr std::size_t names_shown = 8;

std::size_t find_object(const Scene& scene, const std::string& name) {
  if (scene.objects.empty()) throw Error(ErrorKind::usage, "", "the scene has no object to trace");
  if (name.empty()) return 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].name == name) return i;
  std::string known;
  for (std::size_t i = 0; i < std::min(scene.objects.size(), names_shown); ++i)
    known += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", scene.objects[i].name);
  if (scene.objects.size() > names_shown) known += fmt::format(" and {} more", scene.objects.size() - names_shown);
  throw Error(ErrorKind::usage, "", fmt::format("there is no object \"{}\"; there are {}", name, known));
}

// The plan of the frame with nothing left out; none where an object that is out of view does not fit into fp32.
std::optional<Plan> whole_plan(const Planner& planner, std::int64_t frame) try {
  return planner.plan(frame);
} catch (const Error&) {
  return std::nullopt;
}

void start_at_vertex(const Scene& scene, const Object& object, const Draw* draw, std::size_t vertex, Trace& trace) {
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
  if (vertex >= mesh.positions.size())
    throw Error(ErrorKind::usage, "",
                fmt::format("vertex {} of object \"{}\"; its mesh has {} vertices, 0 to {}", vertex, object.name,
                            mesh.positions.size(), mesh.positions.size() - 1));
  trace.vertex = vertex;
  morph_point(mesh, vertex, weights_at(object.morph, scene.timeline.time, trace.frame), trace);
  trace.on_springs = draw != nullptr && draw->displaced;
  if (trace.on_springs) trace.start = start_at(draw->displaced->positions[vertex]);
}

// Which planes of the view volume it is outside of, in words.
void note_planes(const glm::dvec4& clip, const Convention& convention, std::vector<std::string>& notes) {
  const double x = clip.x, y = clip.y, z = clip.z, w = clip.w;
  if (x < -w) notes.push_back("left of the view: x < -w");
  if (x > w) notes.push_back("right of the view: x > w");
  if (y < -w) notes.push_back("below the view: y < -w");
  if (y > w) notes.push_back("above the view: y > w");
  const bool from_0 = convention.depth == NdcDepth::zero_to_one;
  if (z < (from_0 ? 0 : -w))
    notes.push_back(from_0 ? "nearer than the near plane: z < 0" : "nearer than the near plane: z < -w");
  if (z > w) notes.push_back("beyond the far plane: z > w");
}

void note_undivided(const TracePoint& clip, double distance, std::vector<std::string>& notes) {
  if (distance < 0)
    notes.push_back(
        fmt::format("behind the eye by {:.6g}: w = {:.6g} is not positive, so there is nothing to divide by; "
                    "clipping cuts what it belongs to at the near plane, before the division",
                    -distance, clip.value.w));
  else if (distance == 0)
    notes.push_back("in the plane through the eye: w = 0, its image is infinitely far away");
  else
    notes.push_back(
        fmt::format("so close to the plane through the eye that fp32 cannot tell w = {:.6g} from 0", clip.value.w));
}

std::optional<glm::ivec2> pixel_at(const glm::dvec4& place, int width, int height) {
  if (!(place.x >= 0 && place.x < width && place.y >= 0 && place.y < height)) return std::nullopt;
  return glm::ivec2(static_cast<int>(place.x), static_cast<int>(place.y));
}

// From clip space to the pixel.
void divide(const StepChain& chain, Trace& trace) {
  const TracePoint clip = chain.point();
  const std::optional<TracePoint> ndc = divided(clip);
  if (!ndc) {
    note_undivided(clip, *trace.distance, trace.notes);
    return;
  }
  note_planes(clip.value, trace.convention, trace.notes);
  trace.stages.push_back(division_stage(clip, *ndc, chain));
  trace.stages.push_back(viewport_stage(trace.width, trace.height, *ndc, trace.convention, chain));
  trace.pixel = pixel_at(trace.stages.back().after.value, trace.width, trace.height);
  if (!trace.pixel) trace.notes.push_back("no pixel: pixels are half-open, and this is none of the picture's");
}

}  // namespace

const char* name_of(TraceSpace space) {
  switch (space) {
    case TraceSpace::object:
      return "object";
    case TraceSpace::world:
      return "world";
    case TraceSpace::eye:
      return "eye";
    case TraceSpace::clip:
      return "clip";
    case TraceSpace::ndc:
      return "NDC";
    case TraceSpace::viewport:
      return "viewport";
  }
  return "";
}

Trace trace(const Scene& scene, std::int64_t frame, const TraceRequest& request) {
  return trace_object(scene, frame, find_object(scene, request.object), request);
}

Trace trace_object(const Scene& scene, std::int64_t frame, std::size_t index, const TraceRequest& request) {
  const Object& object = scene.objects[index];
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
  const FrameState state = evaluate(scene.timeline, frame);
  const Planner planner(scene, {.leave_out = false});
  const std::optional<Plan> plan = whole_plan(planner, frame);
  const Draw* const draw = plan ? find_draw(**plan, index) : nullptr;

  Trace trace;
  trace.frame = frame;
  trace.width = scene.image.width;
  trace.height = scene.image.height;
  trace.convention = request.convention;
  trace.object = object.name;
  trace.mesh = mesh.name;
  trace.vertices = mesh.positions.size();
  if (request.point) {
    if (!is_finite(*request.point)) throw Error(ErrorKind::usage, "", "the point to trace is not finite");
    trace.base = *request.point;
    trace.start = start_at(*request.point);
  } else {
    start_at_vertex(scene, object, draw, request.vertex, trace);
  }
  trace.start = handed(request.convention, trace.start);

  const double aspect = static_cast<double>(trace.width) / trace.height;
  StepChain chain(request.convention.vectors, trace.start);
  trace.stages.push_back(model_stage(
      model_steps(scene.timeline.nodes, object.node, tick_of(scene.timeline.time, frame)), request.convention, chain));
  trace_plane(state.camera, glm::dvec3(handed(request.convention, chain.point()).value), trace);
  trace.stages.push_back(view_stage(state.camera, request.convention, chain));
  const double eye_z = chain.point().value.z;
  trace.distance = (request.convention.handedness == Handedness::left ? eye_z : -eye_z) + 0.0;
  trace.stages.push_back(projection_stage(state.camera.projection, aspect, request.convention, chain));
  if (state.camera.up_replaced)
    trace.notes.push_back("the camera's up is along its view axis or 0: a world axis across it stands in its place");
  if (!state.node_visible[static_cast<std::size_t>(object.node)])
    trace.notes.push_back("the object is not visible at this frame");
  divide(chain, trace);
  if (draw != nullptr && trace.vertex) trace.rendered = rendered_vertex(**plan, *draw, *trace.vertex);
  return trace;
}

}  // namespace morphcl
