#include "host/scene/shot/nearest_name.hpp"

#include <gtest/gtest.h>

namespace morphcl {
namespace {

TEST(Suggestion, NamesTheNearest) {
  EXPECT_EQ(suggestion("fovy_degres", {"far", "fovy_degrees", "near"}), "; did you mean \"fovy_degrees\"?");
  EXPECT_EQ(suggestion("sphree", {"cube", "sphere"}), "; did you mean \"sphere\"?") << "a swap is one edit";
  EXPECT_EQ(suggestion("nea", {"far", "near"}), "; did you mean \"near\"?");
}

TEST(Suggestion, ListsTheNamesWhenNoneIsNear) {
  EXPECT_EQ(suggestion("zoom", {"near", "far"}), "; known: near, far");
  EXPECT_EQ(suggestion("x", {}), "");
  const std::vector<std::string_view> many(20, "name");
  EXPECT_EQ(suggestion("zzzz", many),
            "; known: name, name, name, name, name, name, name, name, name, name, name, name, ...");
}

TEST(Suggestion, TakesNamesOfAnyLength) {
  const std::string huge(1 << 20, 'a');
  EXPECT_EQ(suggestion(huge, {"near"}), "; known: near");
  EXPECT_EQ(suggestion("", {"near"}), "; known: near");
}

}  // namespace
}  // namespace morphcl
