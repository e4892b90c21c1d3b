// Frames that are rendered: their names, hashes, reports, and what --resume and --verify do.
#include <nlohmann/json.hpp>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

class Render : public ToolTest {
 protected:
  Render() { plant("shot.toml", cube_shot()); }

  ToolResult render(std::vector<std::string> options, ToolOptions how = {}) {
    std::vector<std::string> arguments = {"render", path("shot.toml"), "--device", "reference"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    how.folder = folder_;
    return run_tool(arguments, how);
  }

  // The objects of type `type` on stdout; every line of stdout must be an object of schema 1.
  static std::vector<json> objects(const ToolResult& result, const std::string& type) {
    std::vector<json> found;
    for (const std::string& line : result.out_lines()) {
      const json object = json::parse(line);
      EXPECT_EQ(object.at("schema"), 1);
      if (object.at("type") == type) found.push_back(object);
    }
    return found;
  }

  std::map<int, std::string> hashes(std::vector<std::string> options, const std::string& status) {
    options.push_back("--json");
    const ToolResult result = render(options);
    EXPECT_EQ(result.code, 0) << result.err;
    std::map<int, std::string> found;
    for (const json& frame : objects(result, "frame"))
      if (frame.at("status") == status) found[frame.at("frame")] = frame.at("hash");
    return found;
  }
};

TEST_F(Render, DefaultNamesAndTheClosingLine) {
  const ToolResult result = render({});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  ASSERT_EQ(result.out_lines().size(), 1u);
  EXPECT_THAT(result.out, HasSubstr("5 frames rendered on "));
  EXPECT_THAT(result.out, HasSubstr("frames/s): shot.0000.exr to shot.0004.exr"));
  EXPECT_EQ(files(), (std::set<std::string>{"shot.0000.exr", "shot.0001.exr", "shot.0002.exr", "shot.0003.exr",
                                            "shot.0004.exr", "shot.toml"}));
}

// After its last key the cube stands still.
TEST_F(Render, FramesWithTheSamePictureAreCopiedAndReportedSo) {
  const ToolResult result = render({"--frames", "0-7", "--json", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.err;
  std::map<int, json> frames;
  for (const json& frame : objects(result, "frame")) frames[frame.at("frame")] = frame;
  ASSERT_EQ(frames.size(), 8u);
  for (const auto& [number, frame] : frames) {
    EXPECT_EQ(frame.at("status"), number < 5 ? "rendered" : "copied") << number;
    EXPECT_EQ(frame.at("hash") == frames.at(4).at("hash"), number >= 4) << number;
  }
  const json summary = objects(result, "summary").at(0);
  EXPECT_EQ(summary.at("rendered"), 5);
  EXPECT_EQ(summary.at("copied"), 3);
  EXPECT_THAT(render({"--frames", "0-7"}).out, HasSubstr("5 frames rendered, 3 copied on "));
  EXPECT_EQ(hashes({"--frames", "0-7", "--plan", "none"}, "rendered").size(), 8u);
  EXPECT_EQ(hashes({"--frames", "7", "--plan", "none"}, "rendered").at(7), frames.at(7).at("hash").get<std::string>());
}

TEST_F(Render, QuietPrintsNothing) {
  const ToolResult result = render({"--quiet"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(Render, JsonReportsEveryFrameAndASummary) {
  const ToolResult result = render({"--json", "--frames", "1,3", "-o", "f.%03d.exr"});
  const std::vector<json> frames = objects(result, "frame"), summaries = objects(result, "summary");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].at("path"), frames[0].at("frame") == 1 ? "f.001.exr" : "f.003.exr");
  EXPECT_EQ(frames[0].at("hash").get<std::string>().size(), 32u);
  EXPECT_NE(frames[0].at("hash"), frames[1].at("hash"));
  ASSERT_EQ(summaries.size(), 1u);
  EXPECT_EQ(summaries[0].at("rendered"), 2);
  EXPECT_EQ(summaries[0].at("failed"), 0);
  EXPECT_EQ(summaries[0].at("interrupted"), false);
  ASSERT_EQ(result.err_lines().size(), 2u);
  EXPECT_EQ(json::parse(result.err_lines()[1]).at("done"), 2);
}

TEST_F(Render, AFrameIsWhatItsNumberSays) {
  const auto all = hashes({}, "rendered"), alone = hashes({"--frames", "3", "-o", "alone.####.exr"}, "rendered");
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(alone.at(3), all.at(3));
  EXPECT_EQ(test_support::text_of(path("alone.0003.exr")), test_support::text_of(path("shot.0003.exr")));
}

TEST_F(Render, ResumeKeepsWholeFramesAndMakesTheOthersAgain) {
  const auto first = hashes({}, "rendered");
  std::filesystem::remove(folder_ / "shot.0001.exr");
  std::filesystem::resize_file(folder_ / "shot.0002.exr", std::filesystem::file_size(folder_ / "shot.0002.exr") / 2);
  const ToolResult resumed = render({"--resume", "--json"});
  std::map<int, std::string> status;
  for (const json& frame : objects(resumed, "frame")) {
    status[frame.at("frame")] = frame.at("status");
    EXPECT_EQ(frame.at("hash"), first.at(frame.at("frame")));
  }
  EXPECT_EQ(status,
            (std::map<int, std::string>{{0, "kept"}, {1, "rendered"}, {2, "rendered"}, {3, "kept"}, {4, "kept"}}));
  EXPECT_EQ(objects(resumed, "summary").at(0).at("replaced"), 1) << "one was missing, one was damaged";
}

TEST_F(Render, TheClosingLineOfAResumedJobSaysWhatWasKeptAndWhatWasReplaced) {
  render({});
  EXPECT_THAT(render({"--resume"}).out, MatchesRegex("0 frames rendered, 5 kept in [^(]* s: .*\n"));
  std::filesystem::resize_file(folder_ / "shot.0002.exr", 100);
  std::filesystem::remove(folder_ / "shot.0003.exr");
  EXPECT_THAT(render({"--resume"}).out,
              HasSubstr("2 frames rendered (1 in place of files that were damaged or not of this shot and these "
                        "settings), 3 kept on "));
}

TEST_F(Render, ResumeTrustsNoFrameOfAnotherShotOrSize) {
  hashes({}, "rendered");
  EXPECT_EQ(hashes({"--resume", "--size", "16x16"}, "rendered").size(), 5u);
  plant("shot.toml", replaced(cube_shot(), "fovy_degrees = 45.0", "fovy_degrees = 40.0"));
  EXPECT_EQ(hashes({"--resume", "--size", "16x16"}, "rendered").size(), 5u);
  EXPECT_EQ(hashes({"--resume", "--size", "16x16"}, "kept").size(), 5u);
}

TEST_F(Render, LosslessCompressionsHoldTheSamePixels) {
  const auto expected = hashes({"--frames", "2", "-o", "zip.####.exr"}, "rendered");
  for (const char* name : {"none", "rle", "zips", "piz"})
    EXPECT_EQ(hashes({"--frames", "2", "--compression", name, "-o", std::string(name) + ".##.exr"}, "rendered"),
              expected)
        << name;
}

TEST_F(Render, ChannelsThatWereNotAskedForAreNotInTheFile) {
  ASSERT_EQ(render({"--frames", "0", "--channels", "Z"}).code, 0);
  const std::string info = run_tool({"info", path("shot.0000.exr")}).out;
  EXPECT_THAT(info, HasSubstr("Z float"));
  EXPECT_THAT(info, Not(HasSubstr("R half")));
}

TEST_F(Render, DepthIsRoundedWhereAnErrorIsGiven) {
  const auto exact = hashes({"--frames", "2", "-o", "exact.#.exr"}, "rendered");
  const auto rounded = hashes({"--frames", "2", "--z-error", "1e-4", "--verify", "-o", "rounded.#.exr"}, "rendered");
  EXPECT_NE(rounded, exact);
  EXPECT_THAT(run_tool({"info", path("rounded.0002.exr")}).out, HasSubstr("morphclZError"));
  EXPECT_THAT(run_tool({"info", path("exact.0002.exr")}).out, Not(HasSubstr("morphclZError")));
  plant("shot.toml", replaced(cube_shot(), "compression = \"zip\"", "compression = \"zip\"\nz_error = 1e-4"));
  EXPECT_EQ(hashes({"--frames", "2", "-o", "of_shot.#.exr"}, "rendered"), rounded);
  EXPECT_THAT(run_tool({"info", path("shot.toml")}).out, HasSubstr("zip, Z within 0.0001 of itself"));
  const ToolResult plan = run_tool({"plan", path("shot.toml"), "--frame", "2"});
  EXPECT_THAT(plan.out, HasSubstr("z_error is 0.0001: 13 of 23 mantissa bits keep it"));
  EXPECT_EQ(render({"--frames", "2", "--channels", "RGBA"}).code, 0) << "no Z, nothing to round";
  EXPECT_EQ(render({"--frames", "2", "-o", "f.#.png"}).code, 0) << "nor in a PNG";
}

TEST_F(Render, PreviewAndContactSheetAndVerify) {
  const ToolResult result = render({"--frames", "0-1", "--preview", "--contact-sheet", "all.png", "--verify"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("all.png"));
  EXPECT_EQ(files(), (std::set<std::string>{"all.png", "shot.0000.exr", "shot.0000.png", "shot.0001.exr",
                                            "shot.0001.png", "shot.toml"}));
  EXPECT_EQ(test_support::text_of(path("all.png")).substr(1, 3), "PNG");
}

TEST_F(Render, TheBarIsDrawnOnATerminalOnly) {
  const ToolResult colored = render({}, {.environment = {{"TERM", "xterm"}, {"NO_COLOR", ""}},
                                         .standard_error = test_support::StandardError::terminal});
  EXPECT_THAT(colored.err, HasSubstr("5/5 frames"));
  EXPECT_THAT(colored.err, HasSubstr("frames/s"));
  EXPECT_THAT(colored.err, HasSubstr("\033[32m"));
  const ToolResult plain = render({}, {.environment = {{"TERM", "xterm"}, {"NO_COLOR", "1"}},
                                       .standard_error = test_support::StandardError::terminal});
  EXPECT_THAT(plain.err, HasSubstr("5/5 frames"));
  EXPECT_THAT(plain.err, Not(HasSubstr("\033[32m")));
  EXPECT_EQ(
      render({}, {.environment = {{"TERM", "dumb"}}, .standard_error = test_support::StandardError::terminal}).err, "");
  EXPECT_EQ(
      render({"--quiet"}, {.environment = {{"TERM", "xterm"}}, .standard_error = test_support::StandardError::terminal})
          .err,
      "");
}

// Each line that the bar draws begins at a carriage return and ends with an escape that clears the rest.
std::vector<std::string> drawn_lines(const std::string& err) {
  std::vector<std::string> lines;
  for (std::size_t begin = err.find('\r'); begin != std::string::npos;) {
    const std::size_t end = err.find("\033[K", begin);
    lines.push_back(err.substr(begin + 1, end == std::string::npos ? end : end - begin - 1));
    begin = err.find('\r', begin + 1);
  }
  return lines;
}

TEST_F(Render, TheBarFitsTheTerminal) {
  for (const unsigned short columns : std::initializer_list<unsigned short>{20, 33, 60, 200}) {
    const ToolResult result = render({}, {.environment = {{"TERM", "xterm"}, {"NO_COLOR", "1"}},
                                          .standard_error = test_support::StandardError::terminal,
                                          .terminal_columns = columns});
    const std::vector<std::string> lines = drawn_lines(result.err);
    EXPECT_GE(lines.size(), 2u);
    for (const std::string& line : lines) EXPECT_LT(line.size(), columns) << line;
    EXPECT_THAT(result.err, HasSubstr("5/5"));
  }
}

TEST_F(Render, TheBarOfAResumedJobSaysThatItChecks) {
  render({});
  const ToolResult result = render({"--resume"}, {.environment = {{"TERM", "xterm"}, {"NO_COLOR", "1"}},
                                                  .standard_error = test_support::StandardError::terminal});
  EXPECT_THAT(drawn_lines(result.err).at(0), HasSubstr("0/5 frames, checking what is finished"));
}

TEST_F(Render, InfoRecomputesTheHashThatTheFileHolds) {
  const auto all = hashes({"--frames", "2"}, "rendered");
  const ToolResult result = run_tool({"info", path("shot.0002.exr"), "--json"});
  const std::vector<json> images = objects(result, "image");
  ASSERT_EQ(images.size(), 1u);
  EXPECT_EQ(images[0].at("hash"), all.at(2));
  EXPECT_EQ(images[0].at("stored_hash"), all.at(2));
  EXPECT_EQ(images[0].at("frame"), 2);
  EXPECT_EQ(images[0].at("display_window"), "(0, 0) to (31, 17)");
  EXPECT_EQ(objects(result, "channel").size(), 5u);
}

TEST_F(Render, InfoOfADamagedImage) {
  ASSERT_EQ(render({"--frames", "2"}).code, 0);
  std::filesystem::resize_file(folder_ / "shot.0002.exr", std::filesystem::file_size(folder_ / "shot.0002.exr") / 2);
  expect_one_line_error(run_tool({"info", path("shot.0002.exr")}), 65, "shot.0002.exr");
  expect_one_line_error(run_tool({"info", path("none.exr")}), 66, "none.exr");
}

TEST_F(Render, InfoOfAShot) {
  const ToolResult table = run_tool({"info", path("shot.toml")});
  EXPECT_THAT(table.out, HasSubstr("32x18"));
  EXPECT_THAT(table.out, HasSubstr("0-4 at 25 per second"));
  const ToolResult result = run_tool({"info", path("shot.toml"), "--json"});
  ASSERT_EQ(objects(result, "scene").size(), 1u);
  ASSERT_EQ(objects(result, "mesh").size(), 1u);
  EXPECT_EQ(objects(result, "mesh")[0].at("triangles"), 12);
}

TEST_F(Render, InfoOfACamera) {
  const auto info = [&](const std::string& camera) {
    plant("camera.toml", "[image]\nsize = [400, 100]\n[camera]\n" + camera + "[[object]]\nmesh = \"cube\"\n");
    return run_tool({"info", path("camera.toml")}).out;
  };
  // Upright and at 45 degrees to x and z: they vanish on the horizon, at 1 / (4 tan 45) of the picture's half width.
  const std::string two = info("fovy_degrees = 90\neye = [5, 1, 5]\ntarget = [0, 1, 0]\n");
  EXPECT_THAT(two, HasSubstr("perspective, 90 degrees high"));
  EXPECT_THAT(two, HasSubstr("2: x at NDC (-0.25, 0), pixel (150, 50); z at NDC (0.25, 0), pixel (250, 50)"));
  const std::string top = info("projection = \"orthographic\"\nview = \"top\"\ndistance = 10\n");
  EXPECT_THAT(top, HasSubstr("-4 to 4 across, -1 to 1 up; widened along x to fit the image"));
  EXPECT_THAT(info("projection = \"cabinet\"\neye = [0, 0, 5]\ndirection_degrees = 90\nfit = \"crop\"\n"),
              AllOf(HasSubstr("oblique, 1 to the back is drawn (0, 0.5) away"),
                    HasSubstr("-2 to 2 across, -0.5 to 0.5 up; cropped along y to fit the image")));
}

TEST_F(Render, InfoTakesWhereObjectsAreApart) {
  const auto info = [&](const std::vector<std::string>& steps) {
    std::string shot = "[image]\nsize = [40, 30]\n[[object]]\nmesh = \"cube\"\n";
    for (const std::string& step : steps) shot += "[[object.transform]]\n" + step + "\n";
    plant("object.toml", shot);
    return run_tool({"info", path("object.toml")}).out;
  };
  EXPECT_THAT(info({}), HasSubstr("cube, smooth, at (0, 0, 0); put together again within 0"));
  EXPECT_THAT(info({"scale = [2, 3, 4]", "rotate_y_degrees = 30", "translate = [1, 0, -5]"}),
              HasSubstr("at (1, 0, -5), turned 30 degrees about (0, 1, 0), scaled (2, 3, 4); put together"));
  EXPECT_THAT(info({"shear = { xy = 0.5 }"}), HasSubstr("at (0, 0, 0), sheared by xy, xz, yz (0.5, 0, 0); put"));
  EXPECT_THAT(info({"scale = [1, 0, 1]"}), HasSubstr("not to be taken apart: "));
}

TEST_F(Render, PlanSaysWhatIsLeftOutAndWhy) {
  const ToolResult table = run_tool({"plan", path("shot.toml"), "--frame", "2"});
  EXPECT_EQ(table.code, 0);
  EXPECT_THAT(table.out, HasSubstr("frame 2, 32x18"));
  EXPECT_THAT(table.out, HasSubstr("left out"));
  const ToolResult result = run_tool({"plan", path("shot.toml"), "--json"});
  ASSERT_FALSE(objects(result, "plan").empty());
  for (const json& note : objects(result, "plan")) {
    EXPECT_EQ(note.at("frame"), 0);
    EXPECT_TRUE(note.at("done").is_boolean());
    EXPECT_NE(note.at("reason"), "");
  }
}

}  // namespace
}  // namespace morphcl::cli_test
