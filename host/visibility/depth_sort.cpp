#include "host/visibility/depth_sort.hpp"

#include <fmt/core.h>

#include <limits>

#include "host/visibility/overlap_grid.hpp"
#include "morphcl/error.hpp"

namespace morphcl::visibility {

namespace {

enum class Relation { none, hides, cuts };

class DepthSorter {
 public:
  DepthSorter(Pieces& pieces, std::size_t max_pieces)
      : pieces_(pieces),
        surfaces_(pieces.surfaces()),
        max_pieces_(max_pieces),
        grid_(surfaces_.width, surfaces_.height) {
    for (SurfaceId id = 0; id < surfaces_.count(); ++id) add(pieces_.whole(id), no_item);
    for (std::uint32_t i = 0; i < items_.size(); ++i) by_farthest_.push_back(i);
    std::stable_sort(by_farthest_.begin(), by_farthest_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return items_[a].piece.min < items_[b].piece.min; });
    for (const std::uint32_t i : by_farthest_)
      if (!items_[i].piece.box.empty()) grid_.add(i, items_[i].piece.box, items_[i].piece.min);
  }

  DepthSort sort() {
    std::vector<std::uint32_t> left;  // of a surface, the next one last
    for (const std::uint32_t surface : by_farthest_)
      for (left.push_back(surface); !left.empty();) {
        const std::uint32_t i = left.back();
        if (items_[i].state == State::waiting) {
          push(i);
          while (!stack_.empty()) advance();
          continue;
        }
        left.pop_back();
        if (items_[i].state == State::split) left.insert(left.end(), {items_[i].parts[1], items_[i].parts[0]});
      }
    result_.back_to_front.reserve(order_.size());
    for (const std::uint32_t i : order_) result_.back_to_front.push_back(std::move(items_[i].piece));
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t no_item = std::numeric_limits<std::uint32_t>::max();

  enum class State : std::uint8_t { waiting, on_stack, painted, split };  // split: its parts are not both painted
  struct Item {
    Piece piece;
    std::uint32_t whole = no_item;  // that it is a part of
    State state = State::waiting;
    bool asked = false;                     // candidates are known
    std::uint32_t parts[2] = {};            // where split
    std::vector<std::uint32_t> candidates;  // what it may hide and has not been compared with; taken from the last on
  };

  std::uint32_t add(Piece piece, std::uint32_t whole) {
    Item& item = items_.emplace_back();
    item.piece = std::move(piece);
    item.whole = whole;
    return static_cast<std::uint32_t>(items_.size() - 1);
  }

  bool is_painted(std::uint32_t i) const { return items_[i].state == State::painted; }

  // And what it is the last part of.
  void set_painted(std::uint32_t i) {
    items_[i].state = State::painted;
    for (std::uint32_t whole = items_[i].whole; whole != no_item; whole = items_[whole].whole) {
      if (!is_painted(items_[whole].parts[0]) || !is_painted(items_[whole].parts[1])) return;
      items_[whole].state = State::painted;
    }
  }

  void push(std::uint32_t i) {
    items_[i].state = State::on_stack;
    stack_.push_back(i);
    if (items_[i].asked) return;
    items_[i].asked = true;
    std::vector<std::uint32_t> candidates;
    const Piece& piece = items_[i].piece;
    if (!piece.box.empty())
      grid_.for_each_meeting(
          piece.box, piece.max, [&](std::uint32_t other) { return is_painted(other); },
          [&](std::uint32_t other) {
            if (items_[other].piece.surface != piece.surface && !is_painted(other)) candidates.push_back(other);
          });
    items_[i].candidates = std::move(candidates);
  }

  void advance() {
    const std::uint32_t p = stack_.back();
    std::vector<std::uint32_t>& candidates = items_[p].candidates;
    if (candidates.empty()) {
      std::vector<std::uint32_t>().swap(candidates);
      set_painted(p);
      order_.push_back(p);
      stack_.pop_back();
      return;
    }
    const std::uint32_t q = candidates.back();
    if (items_[q].state == State::painted) return candidates.pop_back();
    if (items_[q].state == State::split) {
      candidates.pop_back();
      for (const std::uint32_t part : items_[q].parts)
        if (may_hide(items_[p].piece, items_[part].piece)) candidates.push_back(part);
      return;
    }
    switch (relation(items_[p].piece, items_[q].piece)) {
      case Relation::none:
        return candidates.pop_back();
      case Relation::cuts:
        ++result_.counts.cuts;
        return split_one_of(p, q);
      case Relation::hides:
        break;
    }
    if (items_[q].state == State::on_stack) return break_circle(q);
    ++result_.counts.moved;
    push(q);
  }

  // Not where min-max tests reject it.
  bool may_hide(const Piece& p, const Piece& q) {
    const bool behind = p.max < q.min, apart = !behind && !p.box.meets(q.box);
    result_.counts.pairs += behind || apart;
    result_.counts.min_max_depth += behind;
    result_.counts.min_max_screen += apart;
    return !behind && !apart;
  }

  // Whether P hides a part of Q, so that Q has to be painted before it.
  Relation relation(const Piece& p, const Piece& q) {
    DepthSortCounts& counts = result_.counts;
    if (!may_hide(p, q)) return Relation::none;
    ++counts.pairs;
    const PixelBox common = intersection(p.box, q.box);
    const Surface &of_p = surfaces_[p.surface], &of_q = surfaces_[q.surface];
    const double error = of_p.error + of_q.error;
    const DepthPlane difference = of_p.depth - of_q.depth;
    if (range_over(p.polygon, difference).max <= error) return ++counts.behind_plane, Relation::none;
    if (range_over(q.polygon, difference).max <= error) return ++counts.in_front_of_plane, Relation::none;
    if (are_apart(of_p, of_q)) return ++counts.apart, Relation::none;
    constexpr int few_rows = 8;  // of pixels: looking at them is cheaper than the polygons
    if (common.last_y - common.first_y < few_rows) return relation_of_pixels(p, q, common, difference, error, false);
    const Polygon both = intersection(p.polygon, q.polygon);
    if (both.empty()) return ++counts.apart, Relation::none;
    const Range range = range_over(both, difference);
    if (range.max <= error) return ++counts.behind, Relation::none;
    return relation_of_pixels(p, q, box_of(both, common), difference, error, range.min >= -error);
  }

  // A difference is linear along a row, so that its extremes are at the ends of what the two share. What shares no
  // pixel asks for no order.
  Relation relation_of_pixels(const Piece& p, const Piece& q, const PixelBox& common, const DepthPlane& difference,
                              double error, bool never_farther) {
    const Pieces::Bounds bounds_p = pieces_.bounds_of(p), bounds_q = pieces_.bounds_of(q);
    bool nearer = false, farther = false, shared = false;
    for (int y = common.first_y; y <= common.last_y && !(nearer && (farther || never_farther)); ++y) {
      const Span in_p = pieces_.columns_of(p, bounds_p, y);
      if (in_p.empty()) continue;
      const Span in_q = pieces_.columns_of(q, bounds_q, y);
      const Span both{std::max(in_p.first, in_q.first), std::min(in_p.end, in_q.end)};
      if (both.empty()) continue;
      shared = true;
      for (const int x : {both.first, both.end - 1}) {
        const double value = difference.at(x, y);
        nearer |= value > error;
        farther |= value < -error;
      }
    }
    if (nearer) return farther ? Relation::cuts : Relation::hides;
    ++(shared ? result_.counts.behind : result_.counts.apart);
    return Relation::none;
  }

  static std::int64_t size_of(const PixelBox& box) {
    return std::int64_t{box.last_x - box.first_x + 1} * (box.last_y - box.first_y + 1);
  }

  // Both have pixels on both sides of the other's plane. The smaller one is split: large ones stay whole.
  void split_one_of(std::uint32_t p, std::uint32_t q) {
    const Piece &of_p = items_[p].piece, &of_q = items_[q].piece;
    if (size_of(of_q.box) < size_of(of_p.box))
      split(q, of_p.surface);
    else
      split(p, of_q.surface);
  }

  // The surfaces on the stack from q to the top overlap in a circle, so the plane of one of them cuts another: without
  // such a pair there would be an order, that of a BSP tree.
  void break_circle(std::uint32_t q) {
    ++result_.counts.circles;
    std::size_t first = stack_.size();
    while (stack_[--first] != q) {
    }
    for (std::size_t cut = stack_.size(); cut-- > first;)
      for (std::size_t by = stack_.size(); by-- > first;) {
        const Piece& piece = items_[stack_[cut]].piece;
        const SurfaceId plane = items_[stack_[by]].piece.surface;
        if (plane == piece.surface) continue;
        const Pieces::Sides sides = pieces_.sides_of(piece, pieces_.function_of({.plane = plane}, piece.surface), 0);
        if (sides.front && sides.back) return split(stack_[cut], plane);
      }
    throw Error(ErrorKind::internal, "", "the painter found surfaces in a circle that no plane of theirs cuts");
  }

  void split(std::uint32_t i, SurfaceId plane) {
    ++result_.counts.splits;
    if (surfaces_.count() + result_.counts.splits > max_pieces_)
      throw Error(ErrorKind::bad_input, "",
                  fmt::format("visibility painter needs more than {} pieces: {} of {} surfaces were in order by then; "
                              "bsp, warnock, watkins and z-buffer draw this",
                              max_pieces_, order_.size(), surfaces_.count()));
    // What waits for it to be painted first goes on waiting.
    if (items_[i].state == State::on_stack)
      for (bool found = false; !found; stack_.pop_back()) {
        found = stack_.back() == i;
        items_[stack_.back()].state = State::waiting;
      }
    auto [front, back] = pieces_.split(items_[i].piece, {.plane = plane});
    const std::uint32_t first = add(std::move(back), i), second = add(std::move(front), i);
    Item& whole = items_[i];
    whole.state = State::split;
    whole.parts[0] = first;
    whole.parts[1] = second;
    // What it has been compared with need not be compared with its parts.
    for (const std::uint32_t part : whole.parts) {
      items_[part].asked = whole.asked;
      for (const std::uint32_t candidate : whole.candidates)
        if (may_hide(items_[part].piece, items_[candidate].piece)) items_[part].candidates.push_back(candidate);
    }
    std::vector<std::uint32_t>().swap(whole.candidates);
  }

  Pieces& pieces_;
  const ScreenSurfaces& surfaces_;
  std::size_t max_pieces_;
  OverlapGrid grid_;
  std::vector<Item> items_;
  std::vector<std::uint32_t> by_farthest_, order_;
  std::vector<std::uint32_t> stack_;
  DepthSort result_;
};

}  // namespace

DepthSort sort_by_depth(Pieces& pieces, std::size_t max_pieces) { return DepthSorter(pieces, max_pieces).sort(); }

}  // namespace morphcl::visibility
