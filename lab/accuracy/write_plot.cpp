#include "lab/accuracy/write_plot.hpp"

#include <fmt/core.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#include "lab/accuracy/verdict.hpp"

namespace morphcl::accuracy {

namespace {

// Families stand beside each other, and right of them the names of all marks.
constexpr int panel_width = 330, panel_height = 330, page_heading = 60;

constexpr const char* of_device = "device, ";  // such a variant looks like the host's of the same name, but is a cross

// gnuplot's outlined shapes; each is followed by the filled one. The device's times are crosses.
constexpr int circle = 6, square = 4, triangle = 8, turned_triangle = 10, diamond = 12, pentagon = 14;
constexpr int cross_shape = 1;

struct Mark {
  const char* color;
  int shape;
};

// Variants of several operations look the same in all of their plots.
struct SharedMark {
  std::string_view variant;
  Mark mark;
};
constexpr SharedMark shared_marks[] = {{"morphcl, rounded once", {"#1b6ca8", circle}},
                                       {"composed in fp64, fma", {"#1b6ca8", square}},
                                       {"morphcl in fp64", {"#2e8b57", diamond}},
                                       {"TR-BDF2, 64", {"#2e8b57", triangle}},
                                       {"fp32", {"#d1495b", square}},
                                       {"fp32 naive", {"#d1495b", triangle}},
                                       {"symplectic Euler, 64", {"#d1495b", diamond}},
                                       {"fp64, C library", {"#b8860b", triangle}},
                                       {"fp64", {"#b8860b", circle}}};

// The others by their number among those of their operation: no pair comes twice in 30.
constexpr const char* own_colors[] = {"#6a4c93", "#e07b39", "#008b8b", "#4d4d4d", "#7a9e1f",
                                      "#c2185b", "#5c6bc0", "#795548", "#00838f", "#9e2a2b"};
constexpr int own_shapes[] = {circle, square, triangle, turned_triangle, diamond, pentagon};

const SharedMark* shared_mark(std::string_view variant) {
  const auto* const found = std::find_if(std::begin(shared_marks), std::end(shared_marks),
                                         [variant](const SharedMark& shared) { return shared.variant == variant; });
  return found == std::end(shared_marks) ? nullptr : found;
}

std::string_view name_on_host(std::string_view variant) {
  if (variant.starts_with(of_device)) variant.remove_prefix(std::string_view(of_device).size());
  return variant;
}

// The same in every plot of the operation, whichever variants a plot shows.
Mark mark_of(const OperationReport& operation, std::string_view variant) {
  variant = name_on_host(variant);
  if (const SharedMark* const shared = shared_mark(variant)) return shared->mark;
  std::vector<std::string_view> own;
  for (const Result& result : operation.results) {
    const std::string_view name = name_on_host(result.variant);
    if (name == variant) break;
    if (!shared_mark(name) && std::find(own.begin(), own.end(), name) == own.end()) own.push_back(name);
  }
  return {own_colors[own.size() % std::size(own_colors)], own_shapes[own.size() % std::size(own_shapes)]};
}

std::string gnuplot_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

struct Panel {
  const OperationReport* operation;
  const Family* family;
  std::vector<const Result*> results;  // with a finite error
  double floor = 1, ceiling = 1;       // of the error axis; errors of 0 are drawn on the floor

  double height_of(double error) const { return std::max(error, floor); }
};

Panel make_panel(const OperationReport& operation, const Family& family) {
  const Measure measure = operation.about.plotted;
  Panel panel{&operation, &family, {}};
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  const auto include = [&](double error) {
    if (error > 0) {
      smallest = std::min(smallest, error);
      largest = std::max(largest, error);
    }
  };
  for (const Result& result : operation.results) {
    const double error = result.figures[measure];
    if (result.family != family.name || !(error - error == 0)) continue;
    // What exploded says nothing by how much, and would take the whole axis.
    if (result.figures[Measure::not_finite] > 0 || error > 1e12) continue;
    panel.results.push_back(&result);
    include(error);
  }
  include(operation.about.target);
  if (!(largest > 0)) smallest = largest = 1;
  // Whole decades, one of them below the smallest error for those that are 0.
  panel.floor = std::pow(10.0, std::floor(std::log10(smallest)) - 1);
  panel.ceiling = std::pow(10.0, std::ceil(std::log10(largest) + 0.2));
  return panel;
}

// How gnuplot is to show it: ` with points ...`.
std::string points_of(const OperationReport& operation, const Result& result) {
  const Mark mark = mark_of(operation, result.variant);
  return fmt::format(" with points pt {} ps {} lc rgb '{}'",
                     result.place == "device" ? cross_shape : mark.shape + (result.ships ? 1 : 0),
                     result.ships ? 1.1 : 0.9, mark.color);
}

std::string title_of(const Result& result) {
  const std::string name(name_on_host(result.variant));
  return " title " + gnuplot_quoted(result.place == "device" ? name + " (device)" : name);
}

constexpr const char* target_style = " with lines dt 2 lw 1.5 lc rgb '#c00000' title ";
constexpr const char* front_style = " with steps lw 1.2 lc rgb '#999999' title 'best for its time'";

std::string target_title(const Description& about) { return gnuplot_quoted("target " + printed(about.target)); }

void add_marks(std::string& data, std::string& plots, const Panel& panel, std::size_t index) {
  const Measure measure = panel.operation->about.plotted;
  for (std::size_t v = 0; v < panel.results.size(); ++v) {
    const Result& result = *panel.results[v];
    const double error = panel.height_of(result.figures[measure]);
    data += fmt::format("$m{}_{} << EOD\n", index, v);
    if (result.nanoseconds("host") > 0) data += fmt::format("{:.6g} {:.6g}\n", result.nanoseconds("host"), error);
    data += fmt::format("EOD\n$d{}_{} << EOD\n", index, v);
    const bool device = result.place == "device";
    const double device_time =
        device && !result.timings.empty() ? result.timings.front().minimum_ns : result.nanoseconds("device");
    if (device_time > 0) data += fmt::format("{:.6g} {:.6g}\n", device_time, error);
    data += "EOD\n";
    plots += fmt::format(", ${}{}_{}{}{}", device ? 'd' : 'm', index, v, points_of(*panel.operation, result),
                         title_of(result));
    if (!device && result.nanoseconds("device") > 0)
      plots += fmt::format(", $d{}_{} with points pt {} ps 0.9 lc rgb '{}' notitle", index, v, cross_shape,
                           mark_of(*panel.operation, result.variant).color);
  }
}

std::string panel_program(const Panel& panel, std::size_t index) {
  const Description& about = panel.operation->about;
  const Measure measure = about.plotted;
  std::string data = fmt::format("$front{} << EOD\n", index);
  for (const Result* result : pareto_front(*panel.operation, panel.family->name))
    data +=
        fmt::format("{:.6g} {:.6g}\n", result->timings.front().minimum_ns, panel.height_of(result->figures[measure]));
  data += "EOD\n";
  std::string plots = fmt::format("plot {:.6g}{}{}, $front{}{}", panel.height_of(about.target), target_style,
                                  target_title(about), index, front_style);
  add_marks(data, plots, panel, index);
  std::string program = data;
  program += fmt::format("set title {} noenhanced\n", gnuplot_quoted(about.name + ", " + panel.family->name));
  program += fmt::format("set xlabel {} noenhanced\n", gnuplot_quoted("time, ns " + about.element));
  program += fmt::format("set ylabel {} noenhanced\n", gnuplot_quoted(text_of(measure).axis));
  program += fmt::format("set yrange [{:g}:{:g}]\n", panel.floor * 0.7, panel.ceiling);
  program += fmt::format("set ytics autofreq\nset ytics add ('0' {:g})\n", panel.floor);
  return program + plots + "\n";
}

// A panel of names alone: of all variants that the operation's panels show.
std::string key_program(const OperationReport& operation, const std::vector<Panel>& panels) {
  std::string entries;
  std::vector<std::string_view> named;
  for (const Panel& panel : panels)
    for (const Result* result : panel.results) {
      if (std::find(named.begin(), named.end(), result->variant) != named.end()) continue;
      named.push_back(result->variant);
      entries += ", keyentry" + points_of(operation, *result) + title_of(*result);
    }
  return fmt::format(
      "set key on\nunset border\nunset xtics\nunset ytics\nunset title\nunset xlabel\nunset ylabel\nset yrange [1:2]\n"
      "plot [1:2] NaN{}{}, keyentry{}{}\n"
      "set border 3\nset xtics nomirror\nset ytics nomirror\nset key off\n",
      target_style, target_title(operation.about), front_style, entries);
}

}  // namespace

std::string plot_program(const Report& report, const std::string& path) {
  std::size_t columns = 1, rows = report.operations.size();
  for (const OperationReport& operation : report.operations) columns = std::max(columns, operation.families.size());
  const int width = panel_width * static_cast<int>(columns + 1);
  const int height = panel_height * static_cast<int>(rows) + page_heading;
  std::string program =
      fmt::format("set terminal svg size {},{} enhanced font 'sans-serif,13' background '#ffffff'\nset output {}\n",
                  width, height, gnuplot_quoted(path));
  program +=
      "set logscale xy\nset format x '10^{%T}'\nset format y '10^{%T}'\nset border 3\nset tics nomirror\n"
      "set grid lw 0.5 lc rgb '#dddddd'\nset offsets graph 0.08, graph 0.08, 0, 0\n"
      "set key left center vertical maxcols 1 noenhanced samplen 1.5 spacing 0.9 Left reverse font ',11'\nset key off\n"
      "set lmargin 10\nset rmargin 2\n";
  program += fmt::format(
      "set multiplot layout {},{} title \"Error against time: further down is more exact, further left is faster.\\n"
      "Filled: what morphcl computes; crosses: device; others: host, one thread; 0 is drawn on the lower edge.\" "
      "noenhanced\n",
      rows, columns + 1);
  std::size_t index = 0;
  for (const OperationReport& operation : report.operations) {
    std::vector<Panel> panels;
    for (const Family& family : operation.families) panels.push_back(make_panel(operation, family));
    for (const Panel& panel : panels) program += panel_program(panel, index++);
    for (std::size_t column = panels.size(); column < columns; ++column) program += "set multiplot next\n";
    program += key_program(operation, panels);
  }
  return program + "unset multiplot\n";
}

std::string draw_plots(const Report& report, const std::string& path) {
  FILE* gnuplot = popen("gnuplot 2>/dev/null", "w");
  if (gnuplot == nullptr) return "no plots: gnuplot cannot be started";
  const std::string unfinished = path + ".unfinished", program = plot_program(report, unfinished);
  // One that is missing, or ends early, closes the pipe: that is told by its status, not by a signal that ends us.
  const auto on_closed_pipe = std::signal(SIGPIPE, SIG_IGN);
  std::fwrite(program.data(), 1, program.size(), gnuplot);
  const int status = pclose(gnuplot);
  std::signal(SIGPIPE, on_closed_pipe);
  std::error_code error;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    std::filesystem::rename(unfinished, path, error);
    return error ? "no plots: gnuplot has written none" : "";
  }
  std::filesystem::remove(unfinished, error);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    return "no plots: gnuplot is not installed (apt-get install gnuplot-nox)";
  return "no plots: gnuplot failed";
}

}  // namespace morphcl::accuracy
