#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/render/reference/visibility.hpp"
#include "host/render/trace/morphed_point.hpp"
#include "host/render/trace/rendered_point.hpp"
#include "host/render/trace/trace_object.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/trace.hpp"

namespace morphcl {

namespace {

using SceneVertices = std::vector<std::vector<reference::Vertex>>;

// What the pixel's centre shows: of surfaces that let light through the nearest.
std::optional<reference::Sample> shown_at(const FramePlan& plan, const SceneVertices& vertices, const RasterGrid& grid,
                                          const glm::ivec2& pixel) {
  reference::Visibility visible;
  reference::find_visible(plan, grid, vertices, {pixel.y, plan.height}, 1, visible);
  const std::size_t at = visible.index(pixel.x, pixel.y);
  if (const auto layers = visible.layers_of(at); !layers.empty()) return layers.front().surface;
  if (visible.samples[at].order == reference::no_order) return std::nullopt;
  return visible.samples[at];
}

std::string where_objects_are(const FramePlan& plan, const SceneVertices& vertices) {
  int low_x = std::numeric_limits<int>::max(), high_x = -1, low_y = low_x, high_y = -1;
  for (const auto& draw : vertices)
    for (const reference::Vertex& vertex : draw)
      if (vertex.outcode == 0) {
        const int x = vertex.screen.x / layout::subpixels, y = vertex.screen.y / layout::subpixels;
        low_x = std::min(low_x, x);
        high_x = std::max(high_x, x);
        low_y = std::min(low_y, y);
        high_y = std::max(high_y, y);
      }
  low_x = std::max(low_x, 0);
  low_y = std::max(low_y, 0);
  high_x = std::min(high_x, plan.width - 1);
  high_y = std::min(high_y, plan.height - 1);
  if (high_x < low_x || high_y < low_y) return "no object is in view";
  return fmt::format("vertices lie in columns {} to {} and rows {} to {}", low_x, high_x, low_y, high_y);
}

std::vector<std::size_t> corners_of(const Draw& draw, std::size_t primitive) {
  if (draw.shading == Shading::wireframe) {
    const glm::uvec2 edge = wireframe_edges(*draw.mesh)[primitive];
    return {edge.x, edge.y};
  }
  const glm::uvec3& triangle = draw.mesh->triangles[primitive];
  return {triangle.x, triangle.y, triangle.z};
}

glm::dvec3 picture_part(const glm::dvec4& clip) { return {clip.x, clip.y, clip.w}; }

// Of the corners, up to a common factor.
std::vector<double> weights_in_space(const std::vector<TraceCorner>& corners, const glm::dvec2& ndc) {
  const glm::dvec3 q(ndc, 1), c0 = picture_part(corners[0].clip), c1 = picture_part(corners[1].clip);
  if (corners.size() == 2) {
    // Along the line's longer axis, as lines are drawn.
    const glm::dvec2 d = glm::dvec2(c1) * c0.z - glm::dvec2(c0) * c1.z;
    const int axis = std::abs(d.x) >= std::abs(d.y) ? 0 : 1;
    const double first = c1[axis] - ndc[axis] * c1.z, second = ndc[axis] * c0.z - c0[axis];
    return {first, second};
  }
  const glm::dvec3 c2 = picture_part(corners[2].clip);
  return {glm::dot(q, glm::cross(c1, c2)), glm::dot(q, glm::cross(c2, c0)), glm::dot(q, glm::cross(c0, c1))};
}

void weigh(PixelTrace& trace) {
  std::vector<double> b = weights_in_space(trace.corners, trace.ndc);
  double sum = 0, picture = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    sum += b[i];
    picture += b[i] * trace.corners[i].clip.w;
  }
  for (std::size_t i = 0; i < b.size(); ++i) {
    TraceCorner& corner = trace.corners[i];
    corner.weight = b[i] / sum;
    corner.picture_weight = b[i] * corner.clip.w / picture;
    trace.in_object += corner.weight * corner.position;
    trace.divisible = trace.divisible && corner.clip.w > 0;
  }
  for (const TraceCorner& corner : trace.corners) {
    trace.mean_distance += corner.picture_weight * corner.distance;
    trace.mean_depth += corner.picture_weight * corner.clip.z / corner.clip.w;
  }
}

void find_ray(const glm::dmat4& projection, const glm::dmat4& world_to_eye, PixelTrace& trace) {
  const glm::dvec2 scale(projection[0][0], projection[1][1]), slant(projection[2][0], projection[2][1]);
  const glm::dvec2 shift(projection[3][0], projection[3][1]);
  if (trace.parallel) {
    trace.eye_from = glm::dvec3((trace.ndc - shift) / scale, 0);
    trace.eye_along = glm::dvec3(slant / scale, -1);
  } else {
    trace.eye_along = glm::dvec3((trace.ndc + slant) / scale, -1);
  }
  const glm::dmat4 eye_to_world = rigid_inverse(world_to_eye);
  trace.world_from = glm::dvec3(eye_to_world * glm::dvec4(trace.eye_from, 1));
  trace.world_along = glm::dvec3(eye_to_world * glm::dvec4(trace.eye_along, 0));
}

void place_corners(const Scene& scene, const Draw& draw, const FrameState& state, const glm::dmat4& projection,
                   PixelTrace& trace) {
  const Object& object = scene.objects[draw.object];
  const std::vector<double> weights = weights_at(object.morph, scene.timeline.time, state.frame);
  const glm::dmat4 to_eye = state.camera.world_to_eye * state.node_to_world[static_cast<std::size_t>(object.node)];
  for (const std::size_t vertex : corners_of(draw, trace.primitive)) {
    TraceCorner corner;
    corner.vertex = vertex;
    Trace morphed;
    morph_point(*draw.mesh, vertex, weights, morphed);
    corner.position = draw.displaced ? glm::dvec3(draw.displaced->positions[vertex]) : glm::dvec3(morphed.start.value);
    const glm::dvec4 eye = to_eye * glm::dvec4(corner.position, 1);
    corner.clip = projection * eye;
    corner.distance = 0.0 - eye.z;
    trace.corners.push_back(corner);
  }
}

}  // namespace

PixelTrace trace_pixel(const Scene& scene, std::int64_t frame, const glm::ivec2& pixel, const Convention& convention) {
  const Planner planner(scene, {.leave_out = false});
  const Plan planned = planner.plan(frame);
  const FramePlan& plan = *planned;
  const std::string place = fmt::format("pixel ({}, {})", pixel.x, pixel.y);
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= plan.width || pixel.y >= plan.height)
    throw Error(ErrorKind::usage, place,
                fmt::format("outside the picture; 0,0 to {},{} are in it", plan.width - 1, plan.height - 1));
  const RasterGrid grid(plan.width, plan.height);
  SceneVertices vertices;
  for (const Draw& draw : plan.draws) vertices.push_back(reference::project_vertices(draw, plan, grid));
  const std::optional<reference::Sample> shown = shown_at(plan, vertices, grid, pixel);
  if (!shown)
    throw Error(ErrorKind::usage, place,
                fmt::format("shows nothing at frame {}; {}", frame, where_objects_are(plan, vertices)));

  const Draw& draw = plan.draws[shown->draw];
  const FrameState state = evaluate(scene.timeline, frame);
  const double aspect = static_cast<double>(plan.width) / plan.height;
  const glm::dmat4 projection = projection_matrix(state.camera.projection, aspect);
  PixelTrace trace;
  trace.pixel = pixel;
  trace.centre = glm::dvec2(pixel) + 0.5;
  trace.ndc = Viewport{0, 0, static_cast<double>(plan.width), static_cast<double>(plan.height)}.to_ndc(trace.centre);
  trace.object = scene.objects[draw.object].name;
  trace.mesh = draw.mesh->name;
  trace.line = draw.shading == Shading::wireframe;
  trace.primitive = shown->primitive;
  trace.parallel = is_parallel(state.camera.projection);
  trace.depth_a = projection[2][2];
  trace.depth_b = projection[3][2];
  trace.rendered_distance = distance_of(plan, shown->depth);
  place_corners(scene, draw, state, projection, trace);
  weigh(trace);
  find_ray(projection, state.camera.world_to_eye, trace);
  const glm::dmat4& to_world = state.node_to_world[static_cast<std::size_t>(scene.objects[draw.object].node)];
  trace.in_world = glm::dvec3(to_world * glm::dvec4(trace.in_object, 1));
  trace.in_eye = glm::dvec3(state.camera.world_to_eye * glm::dvec4(trace.in_world, 1));
  trace.distance = 0.0 - trace.in_eye.z;
  const glm::dvec4 clip = projection * glm::dvec4(trace.in_eye, 1);
  trace.ndc_depth = clip.z / clip.w;
  trace.forward = trace_object(scene, frame, draw.object, {.point = trace.in_object, .convention = convention});
  return trace;
}

}  // namespace morphcl
