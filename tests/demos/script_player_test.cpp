#include "demos/viewer/script_player.hpp"

#include <gtest/gtest.h>

namespace morphcl::viewer {
namespace {

TEST(ScriptPlayer, HandsOutEveryPressInOrder) {
  ScriptPlayer player(parse_key_script("k3,o,p2"));
  std::vector<Key> keys;
  while (!player.done()) keys.push_back(player.take_next().value());
  const std::vector<Key> expected = {Key::step_forward, Key::step_forward, Key::step_forward,
                                     Key::orthographic, Key::step_back,    Key::step_back};
  EXPECT_EQ(keys, expected);
  EXPECT_EQ(player.take_next(), std::nullopt);
}

TEST(ScriptPlayer, AnEmptyScriptIsDone) { EXPECT_TRUE(ScriptPlayer({}).done()); }

}  // namespace
}  // namespace morphcl::viewer
