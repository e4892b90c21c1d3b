// The [object.elastic] table of a shot.
#include <gtest/gtest.h>

#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

constexpr const char* morphing =
    "[[object]]\nmesh = \"pyramid_to_cube\"\n[[object.track]]\ntarget = \"morph.cube\"\nkeys = [[0, 0], [50, 1]]\n";

TEST(ShotElastic, IsNoneUnlessAskedFor) {
  EXPECT_FALSE(ShotFolder().load(morphing).objects[0].morph.elastic.has_value());
}

TEST(ShotElastic, HasDefaults) {
  const Scene scene = ShotFolder().load(std::string(morphing) + "[object.elastic]\n");
  ASSERT_TRUE(scene.objects[0].morph.elastic.has_value());
  const Elastic& elastic = *scene.objects[0].morph.elastic;
  EXPECT_EQ(elastic.anchor, 400);
  EXPECT_EQ(elastic.stiffness, 4000);
  EXPECT_EQ(elastic.damping, 4);
  EXPECT_EQ(elastic.edge_damping, 0);
  EXPECT_EQ(elastic.rest, EdgeRest::driven);
  EXPECT_EQ(elastic.rule, EdgeStiffness::equal);
  // omega = 20, zeta = 0.1: a thousandth is left ln 1000 / 2 = 3.45 s after the last key.
  EXPECT_EQ(frame_numbers(scene.frames).back(), 50 + 86);
}

TEST(ShotElastic, ReadsItsKeys) {
  const Scene scene = ShotFolder().load(std::string(morphing) +
                                        "[object.elastic]\nanchor = 9\nstiffness = 1e12\ndamping = 0.5\n"
                                        "edge_damping = 1e-8\nrest = \"base\"\nrule = \"by_length\"\n");
  const Elastic& elastic = *scene.objects[0].morph.elastic;
  EXPECT_EQ(elastic.anchor, 9);
  EXPECT_EQ(elastic.stiffness, 1e12);
  EXPECT_EQ(elastic.damping, 0.5);
  EXPECT_EQ(elastic.edge_damping, 1e-8);
  EXPECT_EQ(elastic.rest, EdgeRest::base);
  EXPECT_EQ(elastic.rule, EdgeStiffness::by_length);
}

TEST(ShotElastic, WrongOnesAreRefusedWithTheirPlace) {
  const auto refusal = [](const std::string& line) {
    return ShotFolder().refusal(std::string(morphing) + "[object.elastic]\n" + line);
  };
  EXPECT_EQ(refusal("anchor = 0"), "shot.toml:7:10: anchor is 0; 1e-06 to 1e+16 is possible");
  EXPECT_EQ(refusal("stiffness = -1"), "shot.toml:7:13: stiffness is -1; 0 to 1e+16 is possible");
  EXPECT_EQ(refusal("damping = 1e9"), "shot.toml:7:11: damping is 1000000000; 0 to 100000000 is possible");
  EXPECT_EQ(refusal("edge_damping = \"1 s\""), "shot.toml:7:16: edge_damping is a string; a number is needed");
  EXPECT_EQ(refusal("rest = \"bse\""), "shot.toml:7:8: unknown rest \"bse\"; did you mean \"base\"?");
  EXPECT_EQ(refusal("rule = \"springy\""), "shot.toml:7:8: unknown rule \"springy\"; known: equal, by_length");
  EXPECT_EQ(
      refusal("mass = 1"),
      "shot.toml:7:1: unknown key \"mass\" in elastic; known: anchor, stiffness, damping, edge_damping, rest, rule");
}

TEST(ShotElastic, NeedsAMorphToFollow) {
  EXPECT_EQ(ShotFolder().refusal("[[object]]\nmesh = \"cube\"\n[object.elastic]\n"),
            "shot.toml:3:1: an elastic object follows its morph; the mesh has no morph targets that move vertices");
}

}  // namespace
}  // namespace morphcl
