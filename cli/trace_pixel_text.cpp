#include "cli/trace_pixel_text.hpp"

#include <fmt/format.h>

#include "cli/console.hpp"
#include "cli/table.hpp"
#include "cli/trace_text.hpp"
#include "cli/trace_words.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {

using HitTable = std::vector<std::vector<std::string>>;

void show_rows(const HitTable& rows) {
  for (const std::string& line : aligned(rows)) print_result(line);
}

void show_ray(const PixelTrace& trace) {
  print_result("");
  print_result("pixel -> ray: what its centre may show");
  show_rows({{"  eye space", point_words(trace.eye_from), "along", point_words(trace.eye_along)},
             {"  world", point_words(trace.world_from), "along", point_words(trace.world_along)}});
}

// One column a corner, and one of the hit.
template <class Cell>
std::vector<std::string> row_of(const PixelTrace& trace, const char* name, Cell cell, const std::string& hit) {
  std::vector<std::string> row = {name};
  for (const TraceCorner& corner : trace.corners) row.push_back(cell(corner));
  row.push_back(hit);
  return row;
}

void show_hit(const PixelTrace& trace) {
  print_result("");
  print_result(fmt::format("ray -> hit: {} {} of \"{}\", mesh {}", trace.line ? "edge" : "triangle", trace.primitive,
                           printable(trace.object), printable(trace.mesh)));
  const auto number = [](auto member) {
    return [member](const TraceCorner& corner) { return short_number(corner.*member); };
  };
  HitTable rows;
  rows.push_back(row_of(trace, "", [](const TraceCorner& c) { return fmt::format("vertex {}", c.vertex); }, "hit"));
  rows.push_back(row_of(
      trace, "  object space", [](const TraceCorner& c) { return point_words(c.position); },
      point_words(trace.in_object)));
  rows.push_back(row_of(
      trace, "  w in clip space", [](const TraceCorner& c) { return short_number(c.clip.w); },
      trace.parallel ? "1" : short_number(trace.distance)));
  rows.push_back(row_of(trace, "  distance", number(&TraceCorner::distance), short_number(trace.distance)));
  rows.push_back(row_of(trace, "  weight in the picture", number(&TraceCorner::picture_weight), "sum 1"));
  rows.push_back(row_of(trace, "  weight in space", number(&TraceCorner::weight), "sum 1"));
  show_rows(rows);
  if (!trace.parallel)
    print_result("  perspective correction: weight in space = (weight in the picture / w), over the sum of these");
  show_rows({{"  world", point_words(trace.in_world)}, {"  eye space", point_words(trace.in_eye)}});
}

void show_depth(const PixelTrace& trace) {
  print_result("");
  if (trace.parallel) {
    print_result("parallel projectors: w is 1, both kinds of weights are the same, depth is affine in the distance");
  } else {
    print_result(fmt::format("why depth is -A - B / z and not affine: A = {}, B = {}", short_number(trace.depth_a),
                             short_number(trace.depth_b)));
    if (!trace.divisible) {
      print_result(
          "  a corner lies behind the eye: it has no place in the picture, so no mean over the picture exists");
    } else {
      show_rows(
          {{"  NDC depth of the hit", short_number(trace.ndc_depth), "= -A - B / z"},
           {"  mean of the corners' NDC depths", short_number(trace.mean_depth),
            "by their weights in the picture: the same, because 1 / z is affine in the picture"},
           {"  mean of the corners' distances", short_number(trace.mean_distance),
            fmt::format("by the same weights: not the distance {}, because z is not", short_number(trace.distance))}});
    }
  }
  print_result(fmt::format("  the renderers have the distance {:.9g}, in fp32 from snapped vertices; here {:.9g}",
                           trace.rendered_distance, trace.distance));
}

}  // namespace

void print_pixel_text(const std::string& scene, const PixelTrace& trace) {
  print_result(fmt::format("{} frame {}, pixel ({}, {}): its centre is ({}, {}), in NDC ({}, {})", printable(scene),
                           trace.forward.frame, trace.pixel.x, trace.pixel.y, trace.centre.x, trace.centre.y,
                           short_number(trace.ndc.x), short_number(trace.ndc.y)));
  print_result("the way back is in morphcl's own convention");
  show_ray(trace);
  show_hit(trace);
  show_depth(trace);
  print_result("");
  print_result("the hit on its way to the pixel again:");
  print_trace_text(scene, trace.forward);
}

}  // namespace morphcl::cli
