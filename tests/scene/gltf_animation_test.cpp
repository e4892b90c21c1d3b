// Animations out of glTF files, judged by the independent evaluator and by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "host/scene/gltf/gltf_import.hpp"
#include "tests/scene/gltf_builder.hpp"
#include "tests/scene/gltf_comparison.hpp"
#include "tests/scene/import_error.hpp"

namespace morphcl::test {
namespace {

class GltfAnimation : public testing::Test {
 protected:
  ImportedModel import(const GltfBuilder& file) { return import_gltf(file.write(folder), TimeBase{}); }
  static std::vector<double> value_at(const Track& track, std::int64_t tick) {
    std::vector<double> value(static_cast<std::size_t>(track.width()));
    track.evaluate(tick, value.data());
    return value;
  }
  test_support::TemporaryFolder folder;
};

// Keys that lie unevenly, so that tangents must be scaled by each key distance; some on frames, some between.
const std::vector<float> key_times = {0.25f, 0.5f, 1.3f, 1.75f};

std::vector<float> wave(std::size_t count, float scale) {
  std::vector<float> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(scale * std::sin(1.7f * static_cast<float>(i) + 0.3f));
  return values;
}

std::vector<float> unit_quaternions(std::size_t count, bool with_tangents) {
  std::vector<float> values;
  for (std::size_t key = 0; key < count; ++key) {
    if (with_tangents) values.insert(values.end(), {0.5f, -0.25f, 0.125f, 0.0f});
    const float angle = 1.1f * static_cast<float>(key + 1);
    const float sign = key == 2 ? -1.0f : 1.0f;  // the longer way round, unless it is turned
    values.insert(values.end(),
                  {sign * std::sin(angle) * 0.6f, 0, sign * std::sin(angle) * 0.8f, sign * std::cos(angle)});
    if (with_tangents) values.insert(values.end(), {-0.25f, 0.5f, 0.0f, 0.25f});
  }
  return values;
}

TEST_F(GltfAnimation, EveryPathAndInterpolationAgreesWithTheEvaluator) {
  for (const char* rule : {"STEP", "LINEAR", "CUBICSPLINE"}) {
    SCOPED_TRACE(rule);
    const bool cubic = std::string(rule) == "CUBICSPLINE";
    const std::size_t keys = key_times.size(), parts = cubic ? 3 : 1;
    GltfBuilder file = triangle_file(3);
    file.json["nodes"][0]["translation"] = {1, 2, 3};
    file.node({{"children", {0}}, {"scale", {1, -2, 0.5}}, {"rotation", {0.6, 0, 0, 0.8}}});
    const int input = file.floats(key_times, "SCALAR");
    file.animation(0, "weights", input, file.floats(wave(keys * parts * 3, 2), "SCALAR"), rule);
    file.animation(0, "rotation", input, file.floats(unit_quaternions(keys, cubic), "VEC4"), rule);
    file.animation(0, "scale", input, file.floats(wave(keys * parts * 3, 3), "VEC3"), rule);
    file.animation(1, "translation", input, file.floats(wave(keys * parts * 3, 100), "VEC3"), rule);
    const std::size_t compared = compare_with_evaluator(file.write(folder));
    EXPECT_EQ(compared, (std::size_t{210} + 2 + 2) * (2 * 16 + 3)) << "frames -1 to 212 of 2 matrices and 3 weights";
  }
}

TEST_F(GltfAnimation, NormalizedIntegerWeightsAndRotations) {
  GltfBuilder file = triangle_file(1);
  const int times = file.floats({0, 1}, "SCALAR");
  const int weights = file.accessor<std::uint8_t>({0, 51}, uint8_type, "SCALAR");
  const int rotations = file.accessor<std::int16_t>({0, 0, 0, 32767, 0, 32767, 0, 0}, int16_type, "VEC4");
  file.json["accessors"][weights]["normalized"] = file.json["accessors"][rotations]["normalized"] = true;
  file.animation(0, "weights", times, weights);
  file.animation(0, "rotation", times, rotations);
  const ImportedModel model = import(file);
  const std::int64_t second = TimeBase{}.ticks_per_second();
  EXPECT_EQ(value_at(model.objects[0].morph.tracks[0].track, second), std::vector<double>{51 / 255.0});
  EXPECT_EQ(value_at(model.nodes[0].rotation_track, second), (std::vector<double>{0, 1, 0, 0}));
  EXPECT_EQ(model.duration_seconds, 1);
}

TEST_F(GltfAnimation, OneAnimatedNodeMovesAllItsPrimitives) {
  GltfBuilder file = triangle_file(1);
  file.json["meshes"][0]["primitives"].push_back(file.json["meshes"][0]["primitives"][0]);
  file.node({{"mesh", 0}});
  file.animate(0, "weights", {0, 2}, {0, 1});
  const ImportedModel model = import(file);
  ASSERT_EQ(model.objects.size(), 4u);
  EXPECT_EQ(model.objects[0].morph.tracks.size(), 1u);
  EXPECT_EQ(model.objects[1].morph.tracks.size(), 1u);
  EXPECT_EQ(model.objects[2].morph.tracks.size(), 0u) << "another node of the same mesh";
}

TEST_F(GltfAnimation, AnimationsThatMoveDifferentThingsArePlayedTogether) {
  GltfBuilder file = triangle_file();
  file.animation(0, "translation", file.floats({0}, "SCALAR"), file.floats({1, 0, 0}, "VEC3"));
  file.animation(0, "scale", file.floats({2}, "SCALAR"), file.floats({3, 3, 3}, "VEC3"));
  const ImportedModel model = import(file);
  EXPECT_EQ(value_at(model.nodes[0].translation_track, 0)[0], 1);
  EXPECT_EQ(value_at(model.nodes[0].scale_track, 0)[0], 3);
  EXPECT_TRUE(model.warnings.empty());
  ASSERT_EQ(model.parts.size(), 2u);
  for (const ModelPart& part : model.parts) EXPECT_TRUE(part.used);
}

TEST_F(GltfAnimation, OfAnimationsThatMoveTheSameOneIsPlayed) {
  GltfBuilder file = triangle_file();
  const auto clip = [&](const char* name, const char* path, float last, const std::vector<float>& value) {
    file.animation(0, path, file.floats({last}, "SCALAR"), file.floats(value, "VEC3"));
    file.json["animations"].back()["name"] = name;
  };
  clip("Walk", "translation", 1, {1, 0, 0});
  clip("Run", "scale", 2, {2, 2, 2});
  clip("Jump", "scale", 3, {3, 3, 3});
  const ImportedModel first = import(file);
  EXPECT_EQ(value_at(first.nodes[0].translation_track, 0)[0], 1);
  EXPECT_TRUE(first.nodes[0].scale_track.empty()) << "a pose that no clip holds";
  EXPECT_EQ(first.duration_seconds, 1);
  ASSERT_EQ(first.warnings.size(), 1u);
  EXPECT_NE(first.warnings[0].find("0 'Walk', 1 'Run', 2 'Jump'"), std::string::npos) << first.warnings[0];

  const std::string path = file.write(folder);
  for (const std::string wanted : {"Jump", "2"}) {
    const ImportedModel chosen = import_gltf(path, TimeBase{}, {}, {.animation = wanted});
    EXPECT_TRUE(chosen.nodes[0].translation_track.empty()) << wanted;
    EXPECT_EQ(value_at(chosen.nodes[0].scale_track, 0)[0], 3) << wanted;
    EXPECT_EQ(chosen.duration_seconds, 3) << wanted;
    EXPECT_TRUE(chosen.warnings.empty()) << wanted;
    const ModelPart& last = chosen.parts.back();
    EXPECT_EQ(last.kind, ModelPart::Kind::animation);
    EXPECT_EQ(last.name, "Jump");
    EXPECT_EQ(last.seconds, 3);
    EXPECT_TRUE(last.used);
    EXPECT_FALSE(chosen.parts[chosen.parts.size() - 2].used);
  }
  for (const std::string wanted : {"jump", "3", "-1", "1.0", ""})
    expect_refusal([&] { import_gltf(path, TimeBase{}, {}, {.animation = wanted}); }, ErrorKind::usage, path,
                   "there is no animation '" + wanted + "'; the file has 0 'Walk', 1 'Run', 2 'Jump'");
}

TEST_F(GltfAnimation, ChannelsOfOneAnimationThatMoveTheSame) {
  GltfBuilder file = triangle_file();
  const int times = file.floats({0}, "SCALAR");
  file.animation(0, "translation", times, file.floats({1, 0, 0}, "VEC3"));
  const auto channel = file.json["animations"][0]["channels"][0];
  file.json["animations"][0]["channels"].push_back(channel);
  const ImportedModel model = import(file);
  EXPECT_EQ(value_at(model.nodes[0].translation_track, 0)[0], 1);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_EQ(model.warnings[0], "values driven by several animation channels: 1; the first channel of each is used");
}

TEST_F(GltfAnimation, TimesBelowZeroArePlayedFromZeroOn) {
  GltfBuilder file = triangle_file();
  file.animate(0, "translation", {-1, 1}, {0, 0, 0, 4, 0, 0});
  const ImportedModel model = import(file);
  EXPECT_EQ(value_at(model.nodes[0].translation_track, 0)[0], 2);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("key times start at -1 s; the motion is played from 0 on"), std::string::npos);
}

TEST_F(GltfAnimation, OfKeysOfOneTimeTheLastIsUsed) {
  GltfBuilder file = triangle_file();
  file.animate(0, "translation", {0, 1, 1, 2}, {0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0});
  const ImportedModel model = import(file);
  const Track& track = model.nodes[0].translation_track;
  EXPECT_EQ(value_at(track, TimeBase{}.ticks_per_second())[0], 5);
  EXPECT_EQ(value_at(track, TimeBase{}.ticks_per_second() / 2)[0], 2.5);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("1 keys have the time of the one before"), std::string::npos);
}

TEST_F(GltfAnimation, KeysWithinOneTickBecomeTheLastOfThem) {
  GltfBuilder file = triangle_file();
  const float tick = 1.0f / 25e6f;
  file.animate(0, "translation", {0, 0.1f * tick, 0.2f * tick, 1}, {1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});
  const Track track = import(file).nodes[0].translation_track;
  EXPECT_EQ(value_at(track, 0)[0], 3);
  EXPECT_EQ(value_at(track, TimeBase{}.ticks_per_second())[0], 4);
  EXPECT_EQ(value_at(track, TimeBase{}.ticks_per_second() / 2)[0], 3.5);
}

TEST_F(GltfAnimation, CubicKeysWithinOneTickBecomeAConstant) {
  GltfBuilder file = triangle_file();
  file.animate(0, "translation", {0, 1e-9f}, {9, 9, 9, 1, 1, 1, 9, 9, 9, 9, 9, 9, 2, 3, 4, 9, 9, 9}, "CUBICSPLINE");
  const Track track = import(file).nodes[0].translation_track;
  EXPECT_EQ(value_at(track, -5), (std::vector<double>{2, 3, 4}));
  EXPECT_EQ(value_at(track, 5), (std::vector<double>{2, 3, 4}));
}

TEST_F(GltfAnimation, ChannelsWithoutNodeOrOfUnknownPathsAreLeftOut) {
  GltfBuilder file = triangle_file();
  const int times = file.floats({0}, "SCALAR"), values = file.floats({1, 2, 3}, "VEC3");
  file.animation(0, "translation", times, values);
  file.json["animations"][0]["channels"][0]["target"].erase("node");
  EXPECT_TRUE(import(file).nodes[0].translation_track.empty());
  file.json["animations"][0]["channels"][0]["target"] = {{"node", 0}, {"path", "visibility"}};
  const ImportedModel model = import(file);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("path 'visibility' is not animated"), std::string::npos) << model.warnings[0];
}

}  // namespace
}  // namespace morphcl::test
