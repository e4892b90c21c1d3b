#include "demos/viewer/key.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

namespace morphcl::viewer {
namespace {

TEST(Key, TableHoldsEveryKeyOnceInTheOrderOfTheEnum) {
  int expected = 0;
  for (const KeyInfo& entry : key_table()) EXPECT_EQ(static_cast<int>(entry.key), expected++) << entry.name;
  EXPECT_EQ(expected, static_cast<int>(Key::leave) + 1);
}

TEST(Key, NamesAndAliasesAreDistinctLowerCaseLetters) {
  std::set<std::string> seen;
  for (const KeyInfo& entry : key_table()) {
    for (const std::string_view name : {entry.name, entry.alias}) {
      if (name.empty()) continue;
      EXPECT_TRUE(seen.emplace(name).second) << name << " is used twice";
      for (const unsigned char c : name) EXPECT_TRUE(std::islower(c)) << name;
    }
  }
}

TEST(Key, IsFoundByNameAliasAndUpperCase) {
  EXPECT_EQ(find_key("k"), Key::step_forward);
  EXPECT_EQ(find_key("q"), Key::step_forward);
  EXPECT_EQ(find_key("K"), Key::step_forward);
  EXPECT_EQ(find_key("Left"), Key::orbit_left);
  EXPECT_EQ(find_key("esc"), Key::leave);
}

TEST(Key, IsNotFoundByAnythingElse) {
  for (const char* name : {"", "x", "kk", "lef", "lefty", " k"}) EXPECT_EQ(find_key(name), std::nullopt) << name;
}

}  // namespace
}  // namespace morphcl::viewer
