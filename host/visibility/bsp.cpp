#include "host/visibility/bsp.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "morphcl/error.hpp"

namespace morphcl::visibility {

namespace {

using List = std::vector<std::uint32_t>;

class BspBuilder {
 public:
  BspBuilder(Pieces& pieces, std::size_t max_pieces)
      : pieces_(pieces), surfaces_(pieces.surfaces()), max_pieces_(max_pieces) {}

  Bsp build() {
    List all;
    for (SurfaceId id = 0; id < surfaces_.count(); ++id) {
      if (surfaces_[id].box.empty()) continue;
      all.push_back(static_cast<std::uint32_t>(tree_.pieces.size()));
      tree_.pieces.push_back(pieces_.whole(id));
    }
    struct Pending {
      List list;
      std::int32_t parent;
      bool front;
      std::uint64_t depth;
    };
    std::vector<Pending> pending;
    pending.push_back({std::move(all), -1, false, 1});
    while (!pending.empty()) {
      Pending task = std::move(pending.back());
      pending.pop_back();
      if (task.list.empty()) continue;
      tree_.counts.max_depth = std::max(tree_.counts.max_depth, task.depth);
      const auto index = static_cast<std::int32_t>(tree_.nodes.size());
      if (task.parent >= 0) {
        BspNode& parent = tree_.nodes[static_cast<std::size_t>(task.parent)];
        (task.front ? parent.front : parent.back) = index;
      }
      BspNode node;
      List front, back;
      part(std::move(task.list), node, front, back);
      tree_.nodes.push_back(std::move(node));
      pending.push_back({std::move(front), index, true, task.depth + 1});
      pending.push_back({std::move(back), index, false, task.depth + 1});
    }
    return std::move(tree_);
  }

 private:
  enum class Side : std::uint8_t { on, front, back, both };

  // A piece in front of a plane by this much of its own error belongs there: two pieces on the wrong sides are within
  // the sum of their errors then.
  static constexpr double slack_of_error = 0.25;

  const Surface& surface_of(std::uint32_t piece) const { return surfaces_[tree_.pieces[piece].surface]; }

  // `roughly`: high pieces whose corners lie on both sides count as split, whether they have pixels there or not.
  Side side_of(std::uint32_t index, const Splitter& splitter, bool roughly = false) {
    ++tree_.counts.sides;
    const Piece& piece = tree_.pieces[index];
    switch (splitter.kind) {
      case Splitter::Kind::column:
        return piece.box.first_x >= splitter.position ? Side::front
               : piece.box.last_x < splitter.position ? Side::back
                                                      : Side::both;
      case Splitter::Kind::row:
        return piece.box.first_y >= splitter.position ? Side::front
               : piece.box.last_y < splitter.position ? Side::back
                                                      : Side::both;
      case Splitter::Kind::level:
        if (piece.min >= splitter.level) return Side::front;
        if (piece.max < splitter.level) return Side::back;
        break;
      case Splitter::Kind::plane:
        if (piece.surface == splitter.plane) return Side::on;
        break;
    }
    const DepthPlane function = pieces_.function_of(splitter, piece.surface);
    const double slack = slack_of_error * surfaces_[piece.surface].error;
    constexpr int high = 16;  // rows
    if (roughly && piece.box.last_y - piece.box.first_y > high) {
      const auto [min, max] = range_over(piece.polygon, function);
      if (min < -slack && max > slack) return Side::both;
    }
    const auto [front, back] = pieces_.sides_of(piece, function, slack);
    if (front && back) return Side::both;
    if (front || back) return front ? Side::front : Side::back;
    return splitter.kind == Splitter::Kind::plane ? Side::on : Side::front;
  }

  void part(List list, BspNode& node, List& front, List& back) {
    if (need_no_order(list)) {
      ++tree_.counts.leaves;
      node.on = std::move(list);
      return;
    }
    node.leaf = false;
    node.splitter = choose_splitter(list);
    switch (node.splitter.kind) {
      case Splitter::Kind::plane:
        ++tree_.counts.planes;
        break;
      case Splitter::Kind::level:
        ++tree_.counts.levels;
        break;
      case Splitter::Kind::column:
      case Splitter::Kind::row:
        ++tree_.counts.lines;
        break;
    }
    for (const std::uint32_t i : list) {
      switch (side_of(i, node.splitter)) {
        case Side::on:
          node.on.push_back(i);
          break;
        case Side::front:
          front.push_back(i);
          break;
        case Side::back:
          back.push_back(i);
          break;
        case Side::both:
          split(i, node.splitter, front, back);
      }
    }
    // paint() lets the stored depths decide among what lies in one plane.
  }

  void split(std::uint32_t i, const Splitter& splitter, List& front, List& back) {
    auto [in_front, behind] = pieces_.split(tree_.pieces[i], splitter);
    if (in_front.box.empty() || behind.box.empty()) {
      (in_front.box.empty() ? back : front).push_back(i);
      return;
    }
    ++tree_.counts.splits;
    if (surfaces_.count() + tree_.counts.splits > max_pieces_)
      throw Error(ErrorKind::bad_input, "",
                  fmt::format("visibility bsp needs more than {} pieces of {} surfaces; "
                              "warnock, watkins and z-buffer draw this",
                              max_pieces_, surfaces_.count()));
    tree_.pieces[i] = std::move(in_front);
    front.push_back(i);
    back.push_back(static_cast<std::uint32_t>(tree_.pieces.size()));
    tree_.pieces.push_back(std::move(behind));
  }

  // Of few pieces: whether no two of them share a pixel.
  bool need_no_order(const List& list) const {
    constexpr std::size_t few = 24;
    if (list.size() > few) return false;
    for (std::size_t i = 0; i < list.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Piece &a = tree_.pieces[list[i]], &b = tree_.pieces[list[k]];
        if (a.surface == b.surface || !a.box.meets(b.box)) continue;
        if (!are_apart(surfaces_[a.surface], surfaces_[b.surface]) && share_pixels(a, b)) return false;
      }
    return true;
  }

  bool share_pixels(const Piece& a, const Piece& b) const {
    const PixelBox common = intersection(a.box, b.box);
    const Pieces::Bounds bounds_a = pieces_.bounds_of(a), bounds_b = pieces_.bounds_of(b);
    for (int y = common.first_y; y <= common.last_y; ++y) {
      const Span in_a = pieces_.columns_of(a, bounds_a, y);
      if (in_a.empty()) continue;
      const Span in_b = pieces_.columns_of(b, bounds_b, y);
      if (std::max(in_a.first, in_b.first) < std::min(in_a.end, in_b.end)) return true;
    }
    return false;
  }

  // Candidates are planes of some surfaces and the medians of columns, rows and depths, tried on some pieces. What is
  // split counts eight times as much as what the larger side has more than the smaller one.
  Splitter choose_splitter(const List& list) {
    constexpr std::size_t planes = 8, sampled = 48;
    std::vector<Splitter> candidates;
    for (std::size_t k = 0; k < planes && k < list.size(); ++k) {
      const std::size_t i = list.size() <= planes ? k : (2 * k + 1) * list.size() / (2 * planes);
      candidates.push_back({.plane = tree_.pieces[list[i]].surface});
    }
    List sample;
    for (std::size_t k = 0; k < std::min(sampled, list.size()); ++k)
      sample.push_back(list[list.size() <= sampled ? k : k * list.size() / sampled]);
    add_medians(sample, candidates);
    Splitter best;
    double best_cost = -1;
    for (const Splitter& splitter : candidates) {
      double front = 0, back = 0, both = 0;
      for (const std::uint32_t i : sample) {
        const Side side = side_of(i, splitter, true);
        front += side == Side::front;
        back += side == Side::back;
        both += side == Side::both;
      }
      // A line or a level that has all on one side parts nothing.
      const auto pieces = static_cast<double>(sample.size());
      const bool parts = splitter.kind == Splitter::Kind::plane || (front + both < pieces && back + both < pieces);
      const double cost = 8 * both + std::abs(front - back);
      if (!parts || (best_cost >= 0 && cost >= best_cost)) continue;
      best = splitter;
      best_cost = cost;
    }
    return best;
  }

  void add_medians(const List& sample, std::vector<Splitter>& candidates) const {
    std::vector<int> columns, rows;
    std::vector<double> levels;
    for (const std::uint32_t i : sample) {
      const Piece& piece = tree_.pieces[i];
      columns.insert(columns.end(), {piece.box.first_x, piece.box.last_x + 1});
      rows.insert(rows.end(), {piece.box.first_y, piece.box.last_y + 1});
      levels.push_back(piece.min);
    }
    const auto middle = [](auto& values) {
      const auto found = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::nth_element(values.begin(), found, values.end());
      return *found;
    };
    candidates.push_back({.kind = Splitter::Kind::column, .position = middle(columns)});
    candidates.push_back({.kind = Splitter::Kind::row, .position = middle(rows)});
    candidates.push_back({.kind = Splitter::Kind::level, .level = middle(levels)});
  }

  Pieces& pieces_;
  const ScreenSurfaces& surfaces_;
  std::size_t max_pieces_;
  Bsp tree_;
};

}  // namespace

std::vector<std::uint32_t> Bsp::back_to_front() const {
  std::vector<std::uint32_t> order;
  order.reserve(pieces.size());
  struct Step {
    std::int32_t node;
    bool itself;
  };
  std::vector<Step> steps;
  if (!nodes.empty()) steps.push_back({0, false});
  while (!steps.empty()) {
    const auto [index, itself] = steps.back();
    steps.pop_back();
    if (index < 0) continue;
    const BspNode& node = nodes[static_cast<std::size_t>(index)];
    if (itself || node.leaf) {
      order.insert(order.end(), node.on.begin(), node.on.end());
      continue;
    }
    steps.push_back({node.front, false});
    steps.push_back({index, true});
    steps.push_back({node.back, false});
  }
  return order;
}

Bsp build_bsp(Pieces& pieces, std::size_t max_pieces) { return BspBuilder(pieces, max_pieces).build(); }

}  // namespace morphcl::visibility
