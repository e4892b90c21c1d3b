#include <fmt/format.h>

#include "lab/frame_error/difference_files.hpp"

namespace morphcl::accuracy {

namespace {

std::string quoted(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

std::string by_cause(const ErrorByCause& error) {
  std::string fields;
  for (const Tally* tally : {&error.all, &error.storage, &error.arithmetic})
    fields += fmt::format(",{:.9g},{:.9g}", tally->largest, tally->rms());
  return fields;
}

std::string line(const FrameDifference& frame, const Differences& d) {
  return fmt::format("{},{},{},{},{},{},{},{:.9g}", frame.frame, name_of(frame.truth), quoted(d.name), d.pixels,
                     d.outline, d.edge, d.order, d.widest_gap) +
         by_cause(d.color) + by_cause(d.color_spacing) + by_cause(d.depth) + by_cause(d.depth_spacing) +
         fmt::format(",{},{}\n", d.other_color, d.other_depth);
}

}  // namespace

std::string name_of(Truth truth) { return truth == Truth::on_grid ? "grid" : "true"; }

std::string csv_header() {
  std::string header = "frame,truth,object,pixels,outline,edge,order,widest_gap";
  for (const char* value : {"color", "color_spacings", "depth", "depth_spacings"})
    for (const char* cause : {"all", "storage", "arithmetic"})
      for (const char* measure : {"max", "rms"}) header += fmt::format(",{}_{}_{}", value, cause, measure);
  return header + ",other_color,other_depth\n";
}

std::string csv_lines(const FrameDifference& difference) {
  std::string lines = line(difference, difference.total);
  for (const Differences& object : difference.objects) lines += line(difference, object);
  return lines;
}

}  // namespace morphcl::accuracy
