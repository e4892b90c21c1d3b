// The demos without a window: scripts, files and errors.
#include <algorithm>

#include "demos/viewer/eye_lights.hpp"
#include "morphcl/exr.hpp"
#include "tests/demos/demo_program.hpp"
#include "tests/demos/expected_frame.hpp"

namespace morphcl::viewer_test {
namespace {

class Headless : public DemoProgram {
 protected:
  test_support::ProcessResult run(const std::string& program, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), program);
    return test_support::run_process(arguments, options());
  }
  std::string hash_of(const std::string& file) const { return read_exr((folder_ / file).string()).hash; }
  void expect_error(const std::vector<std::string>& arguments, int code, const std::string& part) const {
    const test_support::ProcessResult result = run(kMorphDemo, arguments);
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_EQ(result.err_lines().size(), 1u) << result.err;
    EXPECT_EQ(result.err.rfind("morph_demo: ", 0), 0u) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
  }
};

TEST_F(Headless, StepsAreTheFramesOfTheShot) {
  const Scene scene = demo_scene("pyramid_to_cube.toml", 160, 90);
  const struct {
    const char* script;
    int frame;
  } cases[] = {{"k37", 37}, {"k137", 100}, {"k137,p137", 0}, {"space", 100}, {"k3,q2,P", 4}};
  for (const auto& [script, frame] : cases) {
    const test_support::ProcessResult result = run(kMorphDemo, {"--headless", "--size", "160x90", "--script", script,
                                                                "--out", "out.exr", "--device", "reference"});
    ASSERT_EQ(result.code, 0) << script << ": " << result.err;
    EXPECT_EQ(result.out, "out.exr\n") << script;
    EXPECT_EQ(hash_of("out.exr"), pixel_hash(expected_frame(scene, frame))) << script;
  }
}

TEST_F(Headless, ExportedFrameIsFrame37OnTheDeviceToo) {
  const test_support::ProcessResult result = run(kMorphDemo, {"--headless", "--size", "160x90", "--script", "k37,e"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "morph_demo.0037.exr\n");
  EXPECT_EQ(hash_of("morph_demo.0037.exr"),
            pixel_hash(expected_frame(demo_scene("pyramid_to_cube.toml", 160, 90), 37)));
}

TEST_F(Headless, AChangedViewDoesNotPassForAFrameOfTheShot) {
  const std::vector<std::string> common = {"--headless", "--size", "64x36",  "--device",
                                           "reference",  "--out",  "out.exr"};
  const auto fingerprint_of = [&](const std::string& script) {
    std::vector<std::string> arguments = common;
    arguments.insert(arguments.end(), {"--script", script});
    EXPECT_EQ(run(kMorphDemo, arguments).code, 0) << script;
    return read_exr((folder_ / "out.exr").string()).attributes.fingerprint;
  };
  const std::string own = fingerprint_of("k");
  for (const char* script : {"k,o", "k,w", "k,left", "k,up"}) EXPECT_NE(fingerprint_of(script), own) << script;
  for (const char* script : {"k,o,f", "k,w,s", "k,left72", "k,h"}) EXPECT_EQ(fingerprint_of(script), own) << script;
}

TEST_F(Headless, TeapotsInBothProjectionsAreTheDemosOwn) {
  Scene scene = demo_scene("teapots.toml", 120, 120);
  const struct {
    const char* script;
    Projection projection;
  } cases[] = {{"o", Orthographic{-5, 5, -5, 5, -10, 10}},
               {"h", Orthographic{-5, 5, -5, 5, -10, 10}},
               {"f,k9", Frustum{-2, 2, -2, 2, 3, 10}}};
  for (const auto& [script, projection] : cases) {
    scene.timeline.camera.projection = projection;
    scene.image.background = Background{glm::dvec3(1), glm::dvec3(1)};
    const test_support::ProcessResult result = run(
        kTeapots, {"--headless", "--size", "120x120", "--script", script, "--out", "t.exr", "--device", "reference"});
    ASSERT_EQ(result.code, 0) << script << ": " << result.err;
    EXPECT_EQ(hash_of("t.exr"), pixel_hash(expected_frame(scene, 0))) << script;
  }
}

TEST_F(Headless, TeapotEyeMovesUpByFifths) {
  Scene scene = demo_scene("teapots.toml", 120, 120);
  scene.timeline.camera.projection = Frustum{-2, 2, -2, 2, 3, 10};
  scene.image.background = Background{glm::dvec3(1), glm::dvec3(1)};
  Camera moved = scene.timeline.camera;
  moved.eye = {0, 0.6, 8};
  scene.timeline.lights = viewer::lights_before_eye(scene.timeline, 0, moved);
  scene.timeline.camera = moved;
  const test_support::ProcessResult result = run(
      kTeapots, {"--headless", "--size", "120x120", "--script", "f,w4,s", "--out", "t.exr", "--device", "reference"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(hash_of("t.exr"), pixel_hash(expected_frame(scene, 0)));
}

TEST_F(Headless, TheDeckStepsAndTurns) {
  const auto hash_after = [&](const std::string& script) {
    const test_support::ProcessResult result = run(kMorphDemo, {"--deck", "--headless", "--size", "200x200", "--script",
                                                                script, "--out", "d.exr", "--device", "reference"});
    EXPECT_EQ(result.code, 0) << script << ": " << result.err;
    return hash_of("d.exr");
  };
  const Scene scene = demo_scene("deck.toml", 200, 200);
  EXPECT_EQ(hash_after("h"), pixel_hash(expected_frame(scene, 0)));
  EXPECT_EQ(hash_after("k37"), pixel_hash(expected_frame(scene, 37)));
  EXPECT_EQ(hash_after("k37,t720"), pixel_hash(expected_frame(scene, 37)));
  EXPECT_NE(hash_after("k37,t"), pixel_hash(expected_frame(scene, 37)));
  EXPECT_EQ(hash_after("t60,k100,t60"), hash_after("k100,t120"));
}

TEST_F(Headless, OthersHaveNoDeckAndDoNotTurn) {
  const test_support::ProcessResult result = run(kTeapots, {"--deck", "--headless", "--out", "d.exr"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err_lines().size(), 1u) << result.err;
  const Scene scene = demo_scene("pyramid_to_cube.toml", 160, 90);
  ASSERT_EQ(run(kMorphDemo,
                {"--headless", "--size", "160x90", "--script", "k5,t7", "--out", "out.exr", "--device", "reference"})
                .code,
            0);
  EXPECT_EQ(hash_of("out.exr"), pixel_hash(expected_frame(scene, 5)));
}

TEST_F(Headless, PngIsThePictureWithWhatHShows) {
  const auto picture_of = [&](const std::string& script) {
    const test_support::ProcessResult result = run(
        kMorphDemo, {"--headless", "--size", "320x180", "--script", script, "--out", "a.png", "--device", "reference"});
    EXPECT_EQ(result.code, 0) << script << ": " << result.err;
    return read_png((folder_ / "a.png").string());
  };
  const RgbImage expected = srgb_picture(expected_frame(demo_scene("pyramid_to_cube.toml", 320, 180), 37));
  EXPECT_EQ(difference(picture_of("k37"), expected, 0), "");
  EXPECT_EQ(difference(picture_of("k37,h2"), expected, 0), "");
  const RgbImage with_keys = picture_of("k37,h");
  const auto is_white = [](const Rgb& pixel) { return pixel.red == 255 && pixel.green == 255 && pixel.blue == 255; };
  EXPECT_GT(std::ranges::count_if(with_keys.pixels, is_white), 1000) << "dots of the text";
  EXPECT_EQ(std::ranges::count_if(expected.pixels, is_white), 0);
}

TEST_F(Headless, HelpNamesEveryKeyAndTheGrammar) {
  const test_support::ProcessResult result = run(kMorphDemo, {"--help"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* part : {"k q", "space", "esc", "--script k37,o,w3,e", "--headless", "--size WxH"}) {
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
  }
}

TEST_F(Headless, UsageErrorsAreOneLine) {
  expect_error({"--headless"}, 2, "nothing would be written");
  expect_error({"--headless", "--script", "k3"}, 2, "nothing would be written");
  expect_error({"--out", "a.exr"}, 2, "needs --headless");
  expect_error({"--headless", "--out", "a.jpg"}, 2, "neither .exr nor .png");
  expect_error({"--headless", "--script", "k37,y"}, 2, "press 2 \"y\"");
  expect_error({"--headless", "--script", ""}, 2, "press 1 \"\"");
  expect_error({"--frames", "3"}, 2, "--help");
  expect_error({"--threads", "-1"}, 2, "--threads");
  for (const char* size :
       {"0x4", "4x0", "4", "4x", "x4", "4x4x4", "-4x4", "16385x4", "99999999999x4", "4X4", " 4x4", ""}) {
    if (*size) expect_error({"--headless", "--out", "a.exr", "--size", size}, 2, "is no size");
  }
}

TEST_F(Headless, MissingAndWrongShotsAreOneLine) {
  const std::vector<std::string> common = {"--headless", "--out", "a.exr", "--device", "reference", "--shot"};
  auto with = [&](const std::string& shot) {
    auto arguments = common;
    arguments.push_back(shot);
    return arguments;
  };
  expect_error(with("none.toml"), 66, "none.toml");
  expect_error(with("none.xyz"), 2, "none.xyz");
}

TEST_F(Headless, UnwritableOutputsAndUnknownDevicesAreOneLine) {
  const std::vector<std::string> common = {"--headless", "--size", "16x16", "--device"};
  auto with = [&](const std::vector<std::string>& more) {
    auto arguments = common;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  expect_error(with({"reference", "--out", "/dev/null/a.exr"}), 73, "/dev/null/a.exr");
  expect_error(with({"reference", "--out", "/dev/null/a.png"}), 73, "/dev/null/a.png");
  expect_error(with({"no such device", "--out", "a.exr"}), 69, "no such device");
}

TEST_F(Headless, WithoutADisplayTheWindowSaysSo) {
  for (const char* program : {kMorphDemo, kTeapots}) {
    const test_support::ProcessResult result = run(program, {});
    EXPECT_EQ(result.code, 69);
    EXPECT_EQ(result.err_lines().size(), 1u) << result.err;
    EXPECT_NE(result.err.find("no display"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("use --headless"), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace morphcl::viewer_test
