// Expressions whose value depends on which part of them a compiler evaluates first: C++ leaves the order of a call's
// arguments and of an operator's operands to it, and GCC and Clang differ.
//
// Found by the text: two calls in one expression that both change the same object, neither within the other, with
// nothing between them that orders them (&&, ||, ?, =, <<, >>, or the commas of declarators and of braces). What
// changes an object is a member function that a class of the read files declares without const, a random engine or
// distribution of the standard library, and a local lambda that calls one of these. A list, not a proof: what changes
// the world in another way (files, statics) is not seen.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace morphcl::architecture {

// Member functions that return something and are declared without const, and never with it.
std::set<std::string> changing_members(const std::vector<std::string>& texts);

// One line a finding: "NAME:LINE: random.uniform and random.integer". `name` stands for the file; members that its own
// classes declare count as well.
std::vector<std::string> unordered_calls(const std::string& name, const std::string& text,
                                         std::set<std::string> members);

// The same for all sources below folders of the root. What the members of other classes than a file's own do is looked
// for in `classes`, files or folders below the root.
std::vector<std::string> unordered_calls_below(const std::filesystem::path& root,
                                               const std::vector<std::string>& folders,
                                               const std::vector<std::string>& classes);

}  // namespace morphcl::architecture
