#include "cli/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/console.hpp"
#include "cli/table.hpp"
#include "cli/trace_plane_text.hpp"
#include "cli/trace_words.hpp"
#include "morphcl/error.hpp"

namespace morphcl::cli {

namespace {

using Block = std::vector<std::string>;  // lines of one width

// "[ 1  0  0  -3 ]", columns aligned at their right.
Block matrix_block(const std::string& title, const glm::dmat4& matrix) {
  std::string cell[4][4];
  std::size_t width[4] = {};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      cell[row][column] = short_number(entry(matrix, row, column));
      width[column] = std::max(width[column], cell[row][column].size());
    }
  Block lines = {title};
  for (const auto& row : cell) {
    std::string line = "[";
    for (int column = 0; column < 4; ++column) line += fmt::format(" {:>{}}", row[column], width[column]);
    lines.push_back(line + " ]");
  }
  const std::size_t widest = std::max(lines[0].size(), lines[1].size());
  for (std::string& line : lines) line.resize(widest, ' ');
  return lines;
}

void print_side_by_side(const std::vector<Block>& blocks, const std::string& indent) {
  for (std::size_t row = 0; row < blocks.front().size(); ++row) {
    std::string line = indent;
    for (const Block& block : blocks) line += block[row] + "   ";
    print_result(line.substr(0, line.find_last_not_of(' ') + 1));
  }
}

void show_matrices(const glm::dmat4& matrix, const std::optional<glm::dmat4>& inverse, const glm::dmat4& composite,
                   const std::string& indent) {
  std::vector<Block> blocks = {matrix_block("matrix", matrix)};
  if (inverse) blocks.push_back(matrix_block("inverse", *inverse));
  blocks.push_back(matrix_block("composite, from object space", composite));
  print_side_by_side(blocks, indent);
  if (!inverse) print_result(indent + "no inverse: the step flattens space");
}

std::string coordinates(const glm::dvec4& point) {
  return fmt::format("({}, {}, {}, {})", short_number(point.x), short_number(point.y), short_number(point.z),
                     short_number(point.w));
}

std::vector<std::string> point_row(const std::string& name, const glm::dvec4& values) {
  return {"  " + name, short_number(values.x), short_number(values.y), short_number(values.z), short_number(values.w)};
}

// What comes in and what goes out, what fp32 makes of it, and the bound of its error.
void show_point(const TracePoint* before, const TracePoint& after) {
  std::vector<std::vector<std::string>> rows = {{"", "x", "y", "z", "w"}};
  if (before != nullptr) rows.push_back(point_row("before", before->value));
  rows.push_back(point_row(before == nullptr ? "point" : "after", after.value));
  std::vector<std::string> single = {"  in fp32"}, bound = {"  its error, bound"}, error = {"  its error"};
  for (int i = 0; i < 4; ++i) {
    single.push_back(fmt::format("{:.9g}", after.single[i]));
    error.push_back(fmt::format("{:.1e}", std::abs(after.single[i] - after.value[i])));
    bound.push_back(fmt::format("{:.1e}", after.bound[i]));
  }
  rows.push_back(single);
  rows.push_back(error);
  rows.push_back(bound);
  for (const std::string& line : aligned(rows)) print_result(line);
}

std::string plural_steps(std::size_t count) { return count == 1 ? "1 step" : fmt::format("{} steps", count); }

void show_steps(const std::vector<TraceStep>& steps, const std::string& number, const std::string& indent) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const TraceStep& step = steps[i];
    const std::string name = fmt::format("{}{}", number, i + 1);
    print_result(fmt::format("{}step {}: {} {}", indent, name, step.name, printable(step.detail)));
    show_matrices(step.matrix, step.inverse, step.composite, indent + "  ");
    print_result(fmt::format("{}  the point is now {}", indent, coordinates(step.point.value)));
    if (step.parts.empty()) continue;
    print_result(indent + "  the same in seven steps:");
    show_steps(step.parts, name + ".", indent + "    ");
  }
}

// Columns, or rows of the transposed matrix, are where the axes and the origin come to.
void show_axes(const Trace& trace, const TraceStage& stage) {
  const bool rows = trace.convention.vectors == VectorForm::row;
  const glm::dmat4 columns = rows ? glm::transpose(stage.composite) : stage.composite;
  const auto image = [&](int column) { return point_words(glm::dvec3(columns[column])); };
  print_result(fmt::format("  {} of the composite are images: x axis {}, y axis {}, z axis {}, origin {}",
                           rows ? "rows" : "columns", image(0), image(1), image(2), image(3)));
}

void show_readings(const TraceStage& stage) {
  if (stage.steps.size() < 2) return;
  print_result(
      fmt::format("  two readings: the object moves by steps 1 to {0} in axes that stand still; or the axes move by "
                  "steps {0} to 1, each",
                  stage.steps.size()));
  print_result("  along the axes as the steps before left them. The inverse is the axes' reading of the same words.");
}

void show_stage(const Trace& trace, const TraceStage& stage) {
  print_result("");
  print_result(fmt::format("{} -> {}: {}", name_of(stage.from), name_of(stage.to), stage.what));
  if (stage.divides) {
    print_result(fmt::format("  w = {}: ({} / w, {} / w, {} / w)", short_number(stage.before.value.w),
                             short_number(stage.before.value.x), short_number(stage.before.value.y),
                             short_number(stage.before.value.z)));
  } else {
    if (stage.steps.size() == 1 && stage.steps[0].parts.empty()) {
      print_result(fmt::format("  {} {}", stage.steps[0].name, printable(stage.steps[0].detail)));
    } else {
      show_steps(stage.steps, "", "  ");
      print_result(fmt::format("  all {} together:", plural_steps(stage.steps.size())));
    }
    show_matrices(stage.matrix, stage.inverse, stage.composite, "  ");
    if (stage.to == TraceSpace::world) {
      show_axes(trace, stage);
      show_readings(stage);
    }
  }
  show_point(&stage.before, stage.after);
}

void show_morph(const Trace& trace) {
  if (trace.targets.empty()) return;
  print_result("");
  print_result("morph: where the vertex is in object space");
  std::vector<std::vector<std::string>> rows = {{"  base", "", "", point_words(trace.base)}};
  for (const TraceTarget& target : trace.targets)
    rows.push_back(
        {"  " + printable(target.name), fmt::format("weight {}", short_number(target.weight)),
         fmt::format("{} {}", target.form == TargetForm::absolute ? "towards" : "by", point_words(target.value)),
         point_words(target.after)});
  for (const std::string& line : aligned(rows)) print_result(line);
  if (trace.on_springs) print_result("  its springs have brought it to " + point_words(glm::dvec3(trace.start.value)));
  show_point(nullptr, trace.start);
}

void show_end(const Trace& trace) {
  print_result("");
  for (const std::string& note : trace.notes) print_result(note);
  if (trace.pixel) {
    print_result(fmt::format("pixel ({}, {}): x and y rounded down; pixel centres lie at halves, y grows downwards",
                             trace.pixel->x, trace.pixel->y));
    print_result(fmt::format("distance {} along the view axis, depth {} in NDC", short_number(*trace.distance),
                             short_number(trace.stages[3].after.value.z)));
  }
  if (trace.rendered)
    print_result(fmt::format(
        "the renderers have x {:.9g}, y {:.9g}, w {:.9g} in clip space, and snap to ({}/256, {}/256) "
        "= ({:.9g}, {:.9g}) pixels",
        trace.rendered->clip.x, trace.rendered->clip.y, trace.rendered->clip.z, trace.rendered->subpixel.x,
        trace.rendered->subpixel.y, trace.rendered->subpixel.x / 256.0, trace.rendered->subpixel.y / 256.0));
}

std::string convention_words(const Convention& convention) {
  const bool row = convention.vectors == VectorForm::row, left = convention.handedness == Handedness::left;
  return fmt::format("{} vectors, p' = {}; {}-handed, the eye looks along {}z; NDC depth {} at near to 1 at far",
                     vectors_name(convention), row ? "p M" : "M p", handedness_name(convention), left ? "+" : "-",
                     convention.depth == NdcDepth::zero_to_one ? "0" : "-1");
}

}  // namespace

void print_trace_text(const std::string& scene, const Trace& trace) {
  print_result(fmt::format("{} frame {}, {}x{}: {}, mesh {} of {} vertices", printable(scene), trace.frame, trace.width,
                           trace.height, printable(subject(trace)), printable(trace.mesh), trace.vertices));
  print_result(convention_words(trace.convention));
  print_result("numbers are computed in fp64; \"in fp32\" is the composite, rounded once, times the point, in fp32");
  show_morph(trace);
  for (const TraceStage& stage : trace.stages) show_stage(trace, stage);
  if (trace.plane) print_plane_text(*trace.plane);
  show_end(trace);
}

}  // namespace morphcl::cli
