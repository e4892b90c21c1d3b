#include "anim/hierarchy.hpp"

#include <numeric>
#include <vector>

#include "tests/math/check.hpp"

namespace morphcl {
namespace {

using Parents = std::vector<int>;

TEST(Hierarchy, ParentsComeFirstInAnyOrder) {
  const std::vector<int> parents{3, 0, -1, 2, 2, 1};
  const std::vector<int> order = parents_first(parents);
  ASSERT_EQ(order.size(), parents.size());
  std::vector<bool> seen(parents.size(), false);
  for (const int node : order) {
    EXPECT_FALSE(seen[node]) << node;
    EXPECT_TRUE(parents[node] < 0 || seen[parents[node]]) << node;
    seen[node] = true;
  }
}

TEST(Hierarchy, CyclesAndMissingParentsAreErrors) {
  expect_error([] { parents_first(Parents{0}); }, ErrorKind::bad_input, "nodes[0]");
  expect_error([] { parents_first(Parents{-1, 3, 1, 2, 0}); }, ErrorKind::bad_input,
               "3 nodes are each other's parents");
  expect_error([] { parents_first(Parents{-1, 7}); }, ErrorKind::bad_input, "parent 7 does not exist");
  expect_error([] { parents_first(Parents{-2}); }, ErrorKind::bad_input, "parent -2");
}

TEST(Hierarchy, MillionDeepChainAndCycle) {
  std::vector<int> parents(1'000'000);
  std::iota(parents.begin(), parents.end(), 1);
  parents.back() = -1;  // node 0 is the deepest
  const std::vector<int> order = parents_first(parents);
  EXPECT_EQ(order.front(), 999'999);
  EXPECT_EQ(order.back(), 0);
  parents.back() = 0;
  expect_error([&] { parents_first(parents); }, ErrorKind::bad_input, "1000000 nodes are each other's parents");
}

}  // namespace
}  // namespace morphcl
