// The order in which a hierarchy is evaluated: parents before children.
#pragma once

#include <vector>

namespace morphcl {

struct Node;

// `parents[i]` is the parent of node i, -1 for a root. Returns every node once, parents first. Linear time, no
// recursion: chains may be millions of nodes deep. Error(bad_input): a parent out of range, or a cycle; the message
// names its nodes by index (the first 8 of them).
std::vector<int> parents_first(const std::vector<int>& parents);
std::vector<int> parents_first(const std::vector<Node>& nodes);

}  // namespace morphcl
