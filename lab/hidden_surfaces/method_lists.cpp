#include "lab/hidden_surfaces/method_lists.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace morphcl::hidden_surfaces {

namespace {

// "object:triangle", as morphcl info numbers them.
std::string surface_name(const MethodRun& run, visibility::SurfaceId surface) {
  if (surface == visibility::no_surface) return "";
  const reference::Sample& identity = run.frame.identity(surface);
  return fmt::format("{}:{}", run.plan->draws[identity.draw].object, identity.primitive);
}

std::string splitter_text(const MethodRun& run, const visibility::Splitter& splitter) {
  switch (splitter.kind) {
    case visibility::Splitter::Kind::plane:
      return "plane of " + surface_name(run, splitter.plane);
    case visibility::Splitter::Kind::level:
      return fmt::format("depth {:.9g}", splitter.level);
    case visibility::Splitter::Kind::column:
      return fmt::format("line before column {}", splitter.position);
    case visibility::Splitter::Kind::row:
      break;
  }
  return fmt::format("line before row {}", splitter.position);
}

const char* case_name(visibility::WindowCase ended) {
  static constexpr const char* names[] = {"divided", "empty", "one surface", "surrounded", "one pixel"};
  return names[static_cast<std::size_t>(ended)];
}

// visit(node, depth, side) as the eye walks the tree: back, itself, front.
template <class Visit>
void walk_tree(const visibility::Bsp& tree, Visit visit) {
  struct Step {
    std::int32_t node;
    int depth;
    const char* side;
    bool itself;
  };
  std::vector<Step> steps;
  if (!tree.nodes.empty()) steps.push_back({0, 0, "root", false});
  while (!steps.empty()) {
    const Step step = steps.back();
    steps.pop_back();
    if (step.node < 0) continue;
    const visibility::BspNode& node = tree.nodes[static_cast<std::size_t>(step.node)];
    if (step.itself) {
      visit(step.node, node, step.depth, step.side);
      continue;
    }
    steps.push_back({node.front, step.depth + 1, "front", false});
    steps.push_back({step.node, step.depth, step.side, true});
    steps.push_back({node.back, step.depth + 1, "back", false});
  }
}

}  // namespace

std::string numbers_json(const MethodRun& run) {
  nlohmann::ordered_json numbers;
  numbers["method"] = name_of(run.method());
  numbers["frame"] = run.plan.frame();
  numbers["width"] = run.plan.width();
  numbers["height"] = run.plan.height();
  numbers["seconds"] = run.seconds;
  for (const auto& [name, count] : run.counts) numbers[name] = count;
  return numbers.dump(2) + "\n";
}

std::string within_error_csv(const MethodRun& run) {
  std::string csv = "x,y,shown,by_planes,difference,error\n";
  for (const visibility::ShownRows::WithinError& of : run.shown.within_error) {
    const int x = static_cast<int>(of.pixel % static_cast<std::size_t>(run.shown.width)),
              y = static_cast<int>(of.pixel / static_cast<std::size_t>(run.shown.width));
    const visibility::Surface &shown = run.frame.surfaces()[of.shown], &other = run.frame.surfaces()[of.by_planes];
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{:.9g},{:.9g}\n", x, y, surface_name(run, of.shown),
                   surface_name(run, of.by_planes), (other.depth - shown.depth).at(x, y), shown.error + other.error);
  }
  return csv;
}

std::string windows_csv(const MethodRun& run) {
  std::string csv = "x,y,size,ended,outside,crossing,surrounding,hidden\n";
  for (const visibility::Window& w : run.windows)
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{}\n", w.x, w.y, w.size, case_name(w.ended),
                   w.outside, w.crossing, w.surrounding, w.hidden);
  return csv;
}

std::string spans_csv(const MethodRun& run) {
  std::string csv = "row,first,end,active,shown\n";
  for (const visibility::SampleSpan& span : run.spans)
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{}\n", span.y, span.first, span.end, span.active,
                   surface_name(run, run.shown.opaque[run.shown.index(span.first, span.y)]));
  return csv;
}

std::string order_csv(const MethodRun& run) {
  std::vector<std::uint32_t> parts(run.frame.surfaces().count());
  for (const visibility::Piece& piece : run.order) ++parts[piece.surface];
  std::string csv = "place,surface,pieces_of_surface,farthest,nearest,first_x,first_y,last_x,last_y\n";
  for (std::size_t i = 0; i < run.order.size(); ++i) {
    const visibility::Piece& piece = run.order[i];
    fmt::format_to(std::back_inserter(csv), "{},{},{},{:.9g},{:.9g},{},{},{},{}\n", i, surface_name(run, piece.surface),
                   parts[piece.surface], piece.min, piece.max, piece.box.first_x, piece.box.first_y, piece.box.last_x,
                   piece.box.last_y);
  }
  return csv;
}

std::string tree_text(const MethodRun& run) {
  std::string text = "back to front; a node's back side stands above it, its front side below\n";
  std::size_t place = 0;
  walk_tree(*run.tree, [&](std::int32_t, const visibility::BspNode& node, int depth, const char* side) {
    fmt::format_to(std::back_inserter(text), "{:{}}{}: {}; paints {}", "", 2 * depth, side,
                   node.leaf ? "leaf" : splitter_text(run, node.splitter), node.on.empty() ? "nothing" : "");
    for (std::size_t i = 0; i < node.on.size(); ++i)
      fmt::format_to(std::back_inserter(text), "{}{} ({})", i == 0 ? "" : ", ",
                     surface_name(run, run.tree->pieces[node.on[i]].surface), place++);
    text += "\n";
  });
  return text;
}

std::string tree_dot(const MethodRun& run, int max_depth) {
  std::string dot = "digraph bsp {\n  node [shape=box, fontname=\"sans-serif\", fontsize=10];\n";
  walk_tree(*run.tree, [&](std::int32_t index, const visibility::BspNode& node, int depth, const char*) {
    if (depth > max_depth) return;
    const bool cut_off = depth == max_depth && (node.front >= 0 || node.back >= 0);
    fmt::format_to(std::back_inserter(dot), "  n{} [label=\"{}\\n{} pieces{}\"{}];\n", index,
                   node.leaf ? "leaf" : splitter_text(run, node.splitter), node.on.size(), cut_off ? "\\n…" : "",
                   node.leaf ? ", style=rounded" : "");
    if (depth == max_depth) return;
    if (node.back >= 0) fmt::format_to(std::back_inserter(dot), "  n{} -> n{} [label=\"back\"];\n", index, node.back);
    if (node.front >= 0)
      fmt::format_to(std::back_inserter(dot), "  n{} -> n{} [label=\"front\"];\n", index, node.front);
  });
  return dot + "}\n";
}

}  // namespace morphcl::hidden_surfaces
