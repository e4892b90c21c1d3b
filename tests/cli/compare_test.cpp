// morphcl compare: what it prints and writes, and what it refuses.
#include <nlohmann/json.hpp>

#include <algorithm>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Compare : public ToolTest {
 protected:
  ToolResult compare(std::vector<std::string> options) {
    std::vector<std::string> arguments = {"compare", plant("shot.toml", cube_shot()), "--device", "reference"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_tool(arguments, {.folder = folder_});
  }
};

TEST_F(Compare, PrintsBothTruthsOfTheFirstFrame) {
  const ToolResult result = compare({});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("frame 0, 32x18, fp64 with vertices on the same 1/256 pixel grid"));
  EXPECT_THAT(result.out, HasSubstr("frame 0, 32x18, fp64 with vertices where they truly are"));
  EXPECT_THAT(result.out, HasSubstr("colour, in spacings of half"));
  EXPECT_THAT(result.out, HasSubstr("Z, in spacings of float"));
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
}

TEST_F(Compare, JsonHasEveryFrameAndObject) {
  const ToolResult result = compare({"--frames", "1-3x2", "--truth", "grid", "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  ASSERT_EQ(result.out_lines().size(), 5u) << result.out;
  for (std::size_t i = 0; i < 4; ++i) {
    const json line = json::parse(result.out_lines()[i]);
    EXPECT_EQ(line.at("type"), i % 2 == 0 ? "frame_error" : "object_error");
    EXPECT_EQ(line.at("frame"), i < 2 ? 1 : 3);
    EXPECT_EQ(line.at("truth"), "grid");
    EXPECT_GT(line.at("pixels"), 50);
    EXPECT_GT(line.at("color_storage_max"), 0);
    EXPECT_LE(line.at("color_spacings_storage_max"), 0.5);
    EXPECT_LT(line.at("color_arithmetic_max"), 1e-5);
    EXPECT_LT(line.at("depth_arithmetic_max"), 1e-4);
  }
}

TEST_F(Compare, EndsWithALineATruthAboutAllFrames) {
  const ToolResult result = compare({"--frames", "1-3x2"});
  EXPECT_EQ(result.code, 0) << result.err;
  const std::vector<std::string> lines = result.out_lines();
  const std::string errors =
      "colour differs by at most [0-9.e-]+ \\(frame [13]\\), typically by [0-9.e-]+; "
      "Z by at most [0-9.e-]+ of the distance \\(frame [13]\\), typically by [0-9.e-]+; "
      "[0-9]+ of [0-9]+ pixels show another surface.*";
  EXPECT_THAT(lines.at(lines.size() - 2),
              testing::MatchesRegex("frames 1, 3, against fp64 on the same grid: " + errors));
  EXPECT_THAT(lines.back(),
              testing::MatchesRegex("frames 1, 3, against fp64 with vertices where they truly are: " + errors));
  EXPECT_THAT(compare({"--frame", "2", "--truth", "grid"}).out_lines().back(),
              testing::StartsWith("frame 2, against fp64 on the same grid: colour differs by at most "));
}

// The last line holds what the lines before it hold: the largest of the largest, and the sum of the pixels.
TEST_F(Compare, JsonEndsWithAnObjectATruth) {
  const ToolResult result = compare({"--frames", "1-3x2", "--truth", "grid", "--json"});
  const json first = json::parse(result.out_lines().at(0)), second = json::parse(result.out_lines().at(2));
  const json all = json::parse(result.out_lines().at(4));
  EXPECT_EQ(all.at("type"), "range_error");
  EXPECT_EQ(all.at("frames"), 2);
  EXPECT_EQ(all.at("first"), 1);
  EXPECT_EQ(all.at("last"), 3);
  for (const char* what : {"color_max", "depth_max"}) {
    const double a = first.at(what), b = second.at(what);
    EXPECT_EQ(all.at(what), std::max(a, b));
    EXPECT_EQ(all.at(std::string(what) + "_frame"), a >= b ? 1 : 3);
  }
  EXPECT_EQ(all.at("pixels"), first.at("pixels").get<int>() + second.at("pixels").get<int>());
  const double rms = all.at("color_rms"), one = first.at("color_rms"), other = second.at("color_rms");
  EXPECT_LE(rms, std::max(one, other));
  EXPECT_GE(rms, std::min(one, other));
}

TEST_F(Compare, WritesPicturesAndATable) {
  const ToolResult result = compare({"--frame", "2", "--out", "error"});
  EXPECT_EQ(result.code, 0) << result.err;
  const std::set<std::string> expected = {"shot.toml",
                                          "error/shot.csv",
                                          "error/shot.0002.grid.exr",
                                          "error/shot.0002.grid.png",
                                          "error/shot.0002.true.exr",
                                          "error/shot.0002.true.png"};
  EXPECT_EQ(files(), expected);
  const ToolResult info = run_tool({"info", path("error/shot.0002.true.exr")});
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("mask"));
  const std::string table = test_support::text_of(path("error/shot.csv"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5) << "header; frame and object of both truths";
}

TEST_F(Compare, ShotsWithoutColorAreComparedByDepth) {
  const ToolResult result = compare({"--channels", "Z", "--truth", "grid"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Z, relative"));
  EXPECT_THAT(result.out, Not(HasSubstr("colour")));
}

TEST_F(Compare, SaysThatOneSampleIsCompared) {
  const ToolResult one = compare({"--truth", "grid"});
  EXPECT_EQ(one.err, "");
  const ToolResult several = compare({"--truth", "grid", "--samples", "8"});
  EXPECT_EQ(several.code, 0);
  EXPECT_THAT(several.err, HasSubstr("note: compared is one sample a pixel, its centre, not the 8 of the shot"));
  EXPECT_EQ(several.out, one.out);
  EXPECT_EQ(compare({"--truth", "grid", "--channels", "Z", "--samples", "8"}).err, "") << "Z has one sample anyway";
}

TEST_F(Compare, SaysThatOtherChannelsAreNotCompared) {
  const ToolResult two = compare({"--truth", "grid"});
  for (const char* channels : {"RGBA,Z,N,crypto_object", "velocity"}) {
    const ToolResult more = compare({"--truth", "grid", "--channels", channels});
    EXPECT_EQ(more.code, 0) << more.err;
    EXPECT_THAT(more.err, HasSubstr("note: compared are RGBA and Z, not the other channels of the shot"));
    EXPECT_EQ(more.out, two.out);
  }
}

TEST_F(Compare, SaysThatLinesAreComparedOnePixelWide) {
  const auto compare_lines = [this](const std::string& more) {
    const std::string shot = plant("lines.toml", cube_shot() +
                                                     "[[object]]\nname = \"frame\"\nmesh = \"cube\"\nshading = "
                                                     "\"wireframe\"\n" +
                                                     more);
    return run_tool({"compare", shot, "--device", "reference", "--truth", "grid"}, {.folder = folder_});
  };
  const ToolResult thin = compare_lines(""), wide = compare_lines("line_width = 4\n");
  EXPECT_EQ(thin.err, "");
  EXPECT_THAT(wide.err, HasSubstr("note: frame: lines are compared one pixel wide, not 4"));
  EXPECT_EQ(wide.out, thin.out);
}

TEST_F(Compare, PrintsWhatSamplesMissOfExactCoverage) {
  const ToolResult result = compare({"--truth", "coverage", "--frames", "1,3", "--out", "error"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("frame 1, 32x18, samples against exact coverage; "));
  EXPECT_THAT(result.out, HasSubstr("beyond 1/255"));
  EXPECT_THAT(result.out, HasSubstr("edges of triangles"));
  EXPECT_THAT(result.out, HasSubstr("frames 1, 3, together:"));
  const std::set<std::string> expected = {"shot.toml", "error/shot.coverage.csv"};
  EXPECT_EQ(files(), expected);
  const std::string table = test_support::text_of(path("error/shot.coverage.csv"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 2 * 3 * 5) << "frames, kinds of surfaces, samples";
}

TEST_F(Compare, CoverageAsJsonIsThatOfEveryNumberOfSamples) {
  const ToolResult result = compare({"--truth", "coverage", "--frame", "2", "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  ASSERT_EQ(result.out_lines().size(), 30u) << result.out;
  for (std::size_t i = 0; i < 30; ++i) {
    const json line = json::parse(result.out_lines()[i]);
    EXPECT_EQ(line.at("type"), i < 15 ? "coverage_error" : "range_coverage_error");
    EXPECT_EQ(line.at("truth"), "coverage");
    EXPECT_EQ(line.at("samples"), 1 << i % 5);
    EXPECT_GT(line.at("edge_pixels"), 10);
    EXPECT_LT(line.at("rms"), 0.6 / (1 << i % 5) + 0.1);
    EXPECT_LT(line.at("error_bound"), 1e-9);
    // One frame: the range is the frame.
    for (const char* same : {"max", "rms", "beyond", "shift_x", "spread"})
      EXPECT_EQ(line.at(same), json::parse(result.out_lines()[i % 15]).at(same)) << same;
  }
}

// Whatever the shot asks for: its channels, its samples, and a device that is not used.
TEST_F(Compare, CoverageIsThatOfAllSamplesWhateverTheShotSays) {
  const std::vector<std::string> basic = {"--truth", "coverage", "--frame", "2", "--json"};
  const std::string expected = compare(basic).out;
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--channels", "Z"}, {"--samples", "8"}, {"--threads", "3"}}) {
    std::vector<std::string> options = basic;
    options.insert(options.end(), more.begin(), more.end());
    EXPECT_EQ(compare(options).out, expected) << more[0];
  }
}

TEST_F(Compare, RefusesWhatItCannotDo) {
  expect_one_line_error(compare({"--frame", "1", "--frames", "1-3"}), 2, "--frame");
  expect_one_line_error(compare({"--frames", "3-1"}), 2, "3-1");
  expect_one_line_error(compare({"--frames", "1:3"}), 2, ":");
  expect_one_line_error(compare({"--frame", "9999999"}), 2, "9999999");
  expect_one_line_error(compare({"--truth", "exact"}), 2, "--truth");
  expect_one_line_error(compare({"--size", "16384x16384"}), 2, "8192 x 8192");
  expect_one_line_error(compare({"--device", "abacus"}), 2, "--device");
  expect_one_line_error(compare({"--out", "shot.toml"}), 73, "shot.toml");
  expect_one_line_error(compare({"--truth", "coverage", "--out", "shot.toml"}), 73, "shot.toml");
  expect_one_line_error(run_tool({"compare", path("missing.toml")}), 66, "missing.toml");
}

}  // namespace
}  // namespace morphcl::cli_test
