// A bounding volume hierarchy over the objects of a scene: finds those that may be in view without touching the others.
//
// Objects are sorted along a Morton curve through their centres (Morton 1966; for hierarchies Lauterbach et al., Fast
// BVH construction on GPUs, 2009); every 8 neighbours share a box, every 8 such boxes the next, up to the top.
// Building: O(n log n); a view that sees k of n objects looks at O(k + log n) boxes where objects are spread out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/render/plan/half_spaces.hpp"

namespace morphcl {

// A set of numbers below a limit.
class BitSet {
 public:
  void clear(std::size_t limit) { words_.assign((limit + 63) / 64, 0); }
  void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  bool contains(std::size_t i) const { return words_[i / 64] >> (i % 64) & 1; }
  // Calls visit(i) for every member, in ascending order.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t word = 0; word < words_.size(); ++word)
      for (std::uint64_t rest = words_[word]; rest != 0; rest &= rest - 1)
        visit(word * 64 + static_cast<std::size_t>(__builtin_ctzll(rest)));
  }

 private:
  std::vector<std::uint64_t> words_;
};

class ObjectTree {
 public:
  struct InView {
    BitSet candidates;  // objects that are not outside
    BitSet inside;      // of these, the ones that are inside all planes
  };

  // The bounds of each object; one without bounds is always a candidate. The number of an object is its place here.
  explicit ObjectTree(const std::vector<std::optional<BoundedBox>>& bounds);

  void find(const HalfSpaces& view, InView& found) const;

 private:
  void visit(std::size_t level, std::size_t at, const HalfSpaces& view, InView& found) const;

  std::size_t count_;
  std::vector<std::uint32_t> order_;             // objects along the curve
  std::vector<std::vector<BoundedBox>> levels_;  // 0: the objects' own boxes, in that order
  std::vector<std::uint32_t> anywhere_;          // objects without bounds
};

}  // namespace morphcl
