#include "cli/trace_latex.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/console.hpp"
#include "cli/trace_words.hpp"

namespace morphcl::cli {

namespace {

// As text: what LaTeX would read as commands is escaped, what is not ASCII, which pdflatex may lack a letter for, is
// '?'.
std::string latex_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '\\':
        safe += "\\textbackslash{}";
        break;
      case '^':
        safe += "\\textasciicircum{}";
        break;
      case '~':
        safe += "\\textasciitilde{}";
        break;
      case '<':
        safe += "\\textless{}";
        break;
      case '>':
        safe += "\\textgreater{}";
        break;
      case '"':
        safe += "''";
        break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '_':
      case '{':
      case '}':
        safe += '\\';
        safe += c;
        break;
      default:
        safe += c >= ' ' && c <= '~' ? c : '?';
    }
  }
  return safe;
}

std::string latex_number(double value, const char* form = "{:.6g}") {
  if (!std::isfinite(value)) return "\\infty";
  std::string text = fmt::format(fmt::runtime(form), value + 0.0);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), exponent);
}

std::string latex_matrix(const glm::dmat4& matrix) {
  std::string text = "\\begin{pmatrix}";
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      text += latex_number(entry(matrix, row, column)) + (column < 3 ? " & " : row < 3 ? " \\\\ " : "");
  return text + "\\end{pmatrix}";
}

// Standing for column vectors, lying for row vectors.
std::string latex_vector(const Convention& convention, const glm::dvec4& v, const char* form = "{:.6g}") {
  const char* const next = convention.vectors == VectorForm::row ? " & " : " \\\\ ";
  std::string text = "\\begin{pmatrix}";
  for (int i = 0; i < 4; ++i) text += (i > 0 ? next : "") + latex_number(v[i], form);
  return text + "\\end{pmatrix}";
}

void typeset_display(const std::string& formula) { print_result("\\[ " + formula + " \\]"); }

void typeset_matrices(const std::string& name, const glm::dmat4& matrix, const std::optional<glm::dmat4>& inverse) {
  typeset_display(fmt::format("{} = {}{}", name, latex_matrix(matrix),
                              inverse ? fmt::format(",\\quad {}^{{-1}} = {}", name, latex_matrix(*inverse)) : ""));
}

void typeset_point(const Convention& convention, const TracePoint& point, const std::string& name) {
  typeset_display(fmt::format("{} = {},\\quad \\text{{in fp32 }} {},\\quad |\\text{{error}}| \\le {}", name,
                              latex_vector(convention, point.value),
                              latex_vector(convention, glm::dvec4(point.single), "{:.9g}"),
                              latex_vector(convention, point.bound, "{:.1e}")));
}

void typeset_steps(const Convention& convention, const std::vector<TraceStep>& steps, const std::string& number) {
  print_result("\\begin{itemize}");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const TraceStep& step = steps[i];
    const std::string name = fmt::format("{}{}", number, i + 1);
    print_result(fmt::format("\\item[{}] \\textbf{{{}}} {}", name, latex_text(step.name), latex_text(step.detail)));
    const std::string letter = fmt::format("M_{{{}}}", name);
    typeset_matrices(letter, step.matrix, step.inverse);
    typeset_display(fmt::format("C_{{{}}} = {},\\quad p_{{{}}} = {}", name, latex_matrix(step.composite), name,
                                latex_vector(convention, step.point.value)));
    if (step.parts.empty()) continue;
    print_result("The same in seven steps:");
    typeset_steps(convention, step.parts, name + ".");
  }
  print_result("\\end{itemize}");
}

// The product of a stage, its factors in the order that the convention writes them.
std::string product_words(const TraceStage& stage, const Convention& convention) {
  const std::size_t count = stage.steps.size();
  std::string text = "M";
  if (count < 2) return text;
  text += " =";
  for (std::size_t i = 0; i < count; ++i)
    text += fmt::format(" M_{{{}}}", convention.vectors == VectorForm::row ? i + 1 : count - i);
  return text;
}

void typeset_stage(const Trace& trace, const TraceStage& stage) {
  const bool row = trace.convention.vectors == VectorForm::row;
  print_result(fmt::format("\\section*{{{} $\\to$ {}}}", name_of(stage.from), name_of(stage.to)));
  print_result(latex_text(stage.what) + ".");
  if (stage.divides) {
    const glm::dvec4& p = stage.before.value;
    typeset_display(
        fmt::format("w = {},\\quad \\left(\\frac{{x}}{{w}}, \\frac{{y}}{{w}}, \\frac{{z}}{{w}}\\right) = "
                    "\\left(\\frac{{{}}}{{w}}, \\frac{{{}}}{{w}}, \\frac{{{}}}{{w}}\\right)",
                    latex_number(p.w), latex_number(p.x), latex_number(p.y), latex_number(p.z)));
  } else {
    if (stage.steps.size() == 1 && stage.steps[0].parts.empty())
      print_result(
          fmt::format("\\textbf{{{}}} {}", latex_text(stage.steps[0].name), latex_text(stage.steps[0].detail)));
    else
      typeset_steps(trace.convention, stage.steps, "");
    typeset_matrices("M", stage.matrix, stage.inverse);
    typeset_display(fmt::format("{},\\quad \\text{{from object space: }} C = {}",
                                product_words(stage, trace.convention), latex_matrix(stage.composite)));
    typeset_display(fmt::format("p = {},\\quad p' = {}", latex_vector(trace.convention, stage.before.value),
                                row ? "p\\,M" : "M\\,p"));
  }
  typeset_point(trace.convention, stage.after, "p'");
}

void typeset_morph(const Trace& trace) {
  if (trace.targets.empty()) return;
  print_result("\\section*{morph}");
  for (const TraceTarget& target : trace.targets)
    typeset_display(fmt::format("\\text{{{}, {} {}, weight }} {} :\\quad ({}, {}, {})", latex_text(target.name),
                                target.form == TargetForm::absolute ? "towards" : "by",
                                latex_text(point_words(target.value)), latex_number(target.weight),
                                latex_number(target.after.x), latex_number(target.after.y),
                                latex_number(target.after.z)));
}

std::string latex_triple(const glm::dvec3& v) {
  return fmt::format("({}, {}, {})", latex_number(v.x), latex_number(v.y), latex_number(v.z));
}

std::string latex_matrix(const glm::dmat3& matrix) {
  std::string text = "\\begin{pmatrix}";
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      text += latex_number(matrix[column][row]) + (column < 2 ? " & " : row < 2 ? " \\\\ " : "");
  return text + "\\end{pmatrix}";
}

void typeset_plane(const Trace& trace) {
  print_result("\\section*{the same in the plane}");
  print_result("x and y of the plane are " + latex_text(trace.plane->axes) + " of the world.");
  for (const TracePlaneStep& step : trace.plane->steps) {
    print_result(latex_text(step.name) + ": " + latex_text(step.detail));
    typeset_display(fmt::format("M = {},\\quad M^{{-1}} = {},\\quad C = {},\\quad p' = {}", latex_matrix(step.matrix),
                                latex_matrix(step.inverse), latex_matrix(step.composite), latex_triple(step.point)));
  }
}

void typeset_opening(const std::string& scene, const Trace& trace) {
  print_result("\\documentclass[a4paper,landscape]{article}");
  print_result("\\usepackage{amsmath}");
  print_result("\\pdfpagewidth=\\paperwidth \\pdfpageheight=\\paperheight");
  print_result("\\setlength{\\textwidth}{250mm}\\setlength{\\oddsidemargin}{0mm}\\setlength{\\hoffset}{-10mm}");
  print_result("\\setlength{\\textheight}{160mm}\\setlength{\\topmargin}{-10mm}\\setlength{\\parindent}{0mm}");
  print_result("\\begin{document}");
  print_result(fmt::format("\\section*{{{}, frame {}, ${} \\times {}$: {}}}", latex_text(scene), trace.frame,
                           trace.width, trace.height, latex_text(subject(trace))));
  print_result(fmt::format("{} vectors, {}-handed, NDC depth from ${}$ at near to $1$ at far.",
                           vectors_name(trace.convention), handedness_name(trace.convention),
                           trace.convention.depth == NdcDepth::zero_to_one ? 0 : -1));
}

void typeset_steps_to_the_pixel(const Trace& trace) {
  typeset_morph(trace);
  typeset_point(trace.convention, trace.start, "p");
  for (const TraceStage& stage : trace.stages) typeset_stage(trace, stage);
  if (trace.plane) typeset_plane(trace);
  print_result("\\section*{pixel}");
  if (trace.pixel) print_result(fmt::format("Pixel $({}, {})$.", trace.pixel->x, trace.pixel->y));
  for (const std::string& note : trace.notes) print_result(latex_text(note) + ".\\\\");
  print_result("\\end{document}");
}

// Corners as columns of a table.
void typeset_corners(const PixelTrace& trace) {
  const std::size_t count = trace.corners.size();
  print_result("\\begin{tabular}{l" + std::string(count + 1, 'r') + "}");
  const auto row = [&](const std::string& name, const auto& cell, const std::string& hit) {
    std::string line = name;
    for (const TraceCorner& corner : trace.corners) line += " & $" + cell(corner) + "$";
    print_result(line + " & " + hit + " \\\\");
  };
  row("vertex", [](const TraceCorner& c) { return std::to_string(c.vertex); }, "hit");
  row(
      "$w$", [](const TraceCorner& c) { return latex_number(c.clip.w); },
      "$" + latex_number(trace.parallel ? 1 : trace.distance) + "$");
  row(
      "distance", [](const TraceCorner& c) { return latex_number(c.distance); },
      "$" + latex_number(trace.distance) + "$");
  row("weight in the picture $\\lambda$", [](const TraceCorner& c) { return latex_number(c.picture_weight); }, "1");
  row("weight in space $\\mu$", [](const TraceCorner& c) { return latex_number(c.weight); }, "1");
  print_result("\\end{tabular}");
}

}  // namespace

void print_trace_latex(const std::string& scene, const Trace& trace) {
  typeset_opening(scene, trace);
  typeset_steps_to_the_pixel(trace);
}

void print_pixel_latex(const std::string& scene, const PixelTrace& trace) {
  typeset_opening(scene, trace.forward);
  print_result("\\section*{pixel $\\to$ ray $\\to$ hit}");
  print_result(fmt::format("The centre of pixel $({}, {})$ shows {} {} of {}.\\\\", trace.pixel.x, trace.pixel.y,
                           trace.line ? "edge" : "triangle", trace.primitive, latex_text(trace.object)));
  print_result(fmt::format("Ray in eye space: from ${}$ along ${}$.\\\\", latex_triple(trace.eye_from),
                           latex_triple(trace.eye_along)));
  typeset_corners(trace);
  typeset_display("\\mu_i = \\frac{\\lambda_i / w_i}{\\sum_j \\lambda_j / w_j}");
  if (!trace.parallel)
    typeset_display(
        fmt::format("z_{{\\text{{NDC}}}} = -A - \\frac{{B}}{{z}} = {},\\quad A = {},\\quad B = {},\\quad z = {}",
                    latex_number(trace.ndc_depth), latex_number(trace.depth_a), latex_number(trace.depth_b),
                    latex_number(-trace.distance)));
  print_result(fmt::format("The hit in the world: ${}$. Forwards again:", latex_triple(trace.in_world)));
  typeset_steps_to_the_pixel(trace.forward);
}

}  // namespace morphcl::cli
