#include "cli/compare_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/console.hpp"
#include "cli/json_object.hpp"
#include "cli/table.hpp"
#include "lab/frame_error/difference_files.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {

using accuracy::Differences;
using accuracy::ErrorByCause;
using accuracy::FrameDifference;
using accuracy::Tally;

using Rows = std::vector<std::vector<std::string>>;

void print(const Rows& rows) {
  for (const std::string& line : aligned(rows)) print_result("  " + line);
}

std::string number(double value) { return fmt::format("{:.3g}", value); }

void add_error(Rows& rows, const std::string& what, const ErrorByCause& error) {
  std::vector<std::string> row = {what};
  for (const Tally* tally : {&error.all, &error.storage, &error.arithmetic}) {
    row.push_back(number(tally->largest));
    row.push_back(number(tally->rms()));
  }
  if (error.all.not_finite > 0) row.push_back(fmt::format("{} not finite", error.all.not_finite));
  rows.push_back(std::move(row));
}

// The objects with the most pixels that differ, then those with the largest error.
std::vector<const Differences*> worst_first(const FrameDifference& d) {
  std::vector<const Differences*> objects;
  for (const Differences& object : d.objects) objects.push_back(&object);
  const auto rank = [](const Differences* o) {
    return std::make_pair(o->outline + o->edge + o->order, std::max(o->color.all.largest, o->depth.all.largest));
  };
  std::stable_sort(objects.begin(), objects.end(),
                   [&](const Differences* a, const Differences* b) { return rank(a) > rank(b); });
  return objects;
}

void print_objects(const FrameDifference& d) {
  constexpr std::size_t max_objects = 12;
  Rows rows = {{"object", "pixels", "outline", "edge", "order", "colour max", "Z max"}};
  const std::vector<const Differences*> objects = worst_first(d);
  for (std::size_t i = 0; i < std::min(objects.size(), max_objects); ++i) {
    const Differences& o = *objects[i];
    rows.push_back({printable(o.name), fmt::to_string(o.pixels), fmt::to_string(o.outline), fmt::to_string(o.edge),
                    fmt::to_string(o.order), d.has_color ? number(o.color.all.largest) : "",
                    d.has_depth ? number(o.depth.all.largest) : ""});
  }
  print(rows);
  if (objects.size() > max_objects)
    print_result(fmt::format("  and {} more objects, which differ less (--json and --out have all)",
                             objects.size() - max_objects));
}

void add_error(Json& object, const std::string& what, const ErrorByCause& error) {
  object.update({{what + "_max", error.all.largest},
                 {what + "_rms", error.all.rms()},
                 {what + "_storage_max", error.storage.largest},
                 {what + "_storage_rms", error.storage.rms()},
                 {what + "_arithmetic_max", error.arithmetic.largest},
                 {what + "_arithmetic_rms", error.arithmetic.rms()}});
}

std::string json(const char* type, const FrameDifference& d, const Differences& part, const std::string& drawn_by) {
  Json line = json_object(type, {{"frame", d.frame}, {"truth", accuracy::name_of(d.truth)}, {"drawn_by", drawn_by}});
  if (&part != &d.total) line["object"] = part.name;
  line.update({{"pixels", part.pixels},
               {"outline", part.outline},
               {"edge", part.edge},
               {"order", part.order},
               {"widest_gap", part.widest_gap}});
  if (d.has_color) {
    add_error(line, "color", part.color);
    add_error(line, "color_spacings", part.color_spacing);
    line.update({{"color_not_finite", part.color.all.not_finite}, {"other_color", part.other_color}});
  }
  if (d.has_depth) {
    add_error(line, "depth", part.depth);
    add_error(line, "depth_spacings", part.depth_spacing);
    line.update({{"depth_not_finite", part.depth.all.not_finite}, {"other_depth", part.other_depth}});
  }
  return line_of(line);
}

}  // namespace

void print_difference_table(const FrameDifference& d, const std::string& drawn_by) {
  const Differences& all = d.total;
  print_result(fmt::format("frame {}, {}x{}, {}, drawn by {}:", d.frame, d.width, d.height,
                           d.truth == accuracy::Truth::on_grid
                               ? "fp64 with vertices on the same 1/256 pixel grid (what rounding costs)"
                               : "fp64 with vertices where they truly are (what the grid costs as well)",
                           drawn_by));
  print_result(fmt::format("  {} pixels show something; {} differ in outline, {} at inner edges, {} in depth order{}",
                           all.pixels, all.outline, all.edge, all.order,
                           all.order ? fmt::format(" (by at most {:.2g} of the distance)", all.widest_gap) : ""));
  Rows rows = {{"error where both show the same", "max", "rms", "storage max", "rms", "fp32 max", "rms"}};
  if (d.has_color) {
    add_error(rows, "colour", all.color);
    add_error(rows, "colour, in spacings of half", all.color_spacing);
  }
  if (d.has_depth) {
    add_error(rows, "Z, relative", all.depth);
    add_error(rows, "Z, in spacings of float", all.depth_spacing);
  }
  print(rows);
  if (d.has_color || d.has_depth)
    print_result(fmt::format("  pixels that store another number than the nearest: {}{}{}",
                             d.has_color ? fmt::format("colour {}", all.other_color) : "",
                             d.has_color && d.has_depth ? ", " : "",
                             d.has_depth ? fmt::format("Z {}", all.other_depth) : ""));
  if (d.objects.size() > 1) print_objects(d);
}

void print_difference_json(const FrameDifference& d, const std::string& drawn_by) {
  print_result(json("frame_error", d, d.total, drawn_by));
  for (const Differences& object : d.objects) print_result(json("object_error", d, object, drawn_by));
}

}  // namespace morphcl::cli
