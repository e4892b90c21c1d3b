// What morphcl trace prints, and what it refuses.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class TraceCommand : public ToolTest {
 protected:
  TraceCommand() { plant("shot.toml", cube_shot()); }

  ToolResult trace(std::vector<std::string> options) {
    options.insert(options.begin(), {"trace", path("shot.toml")});
    return run_tool(options, {.folder = folder_});
  }
  std::vector<json> objects(std::vector<std::string> options) {
    options.push_back("--json");
    const ToolResult result = trace(options);
    EXPECT_EQ(result.code, 0) << result.err;
    std::vector<json> found;
    for (const std::string& line : result.out_lines()) found.push_back(json::parse(line));
    return found;
  }
  json stage(const std::vector<json>& objects, const std::string& to) {
    for (const json& object : objects)
      if (object["type"] == "trace_stage" && object["to"] == to) return object;
    return {};
  }
};

TEST_F(TraceCommand, ShowsEverySpaceUpToThePixel) {
  const ToolResult result = trace({});
  EXPECT_EQ(result.code, 0) << result.err;
  for (const char* part : {"object -> world", "world -> eye", "eye -> clip", "clip -> NDC", "NDC -> viewport",
                           "pixel (", "columns of the composite are images", "its error, bound", "the renderers have"})
    EXPECT_THAT(result.out, HasSubstr(part));
  EXPECT_THAT(result.out, Not(HasSubstr("nan")));
}

TEST_F(TraceCommand, RowVectorsTransposeEveryMatrix) {
  const json column = stage(objects({"--frame", "2"}), "eye")["matrix"];
  const json row = stage(objects({"--frame", "2", "--vectors", "row"}), "eye")["matrix"];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_EQ(column[i][j], row[j][i]);
}

TEST_F(TraceCommand, LeftHandedEyesLookAlongPositiveZ) {
  const json right = stage(objects({}), "eye")["point"],
             left = stage(objects({"--handedness", "left"}), "eye")["point"];
  EXPECT_LT(right[2], 0);
  EXPECT_EQ(left[2].get<double>(), -right[2].get<double>());
}

TEST_F(TraceCommand, DepthFrom0To1IsThatOfTheViewport) {
  const json usual = stage(objects({}), "viewport")["point"];
  const json ndc = stage(objects({"--ndc-depth", "zero_to_one"}), "NDC")["point"];
  EXPECT_NEAR(ndc[2], usual[2], 1e-15);
}

TEST_F(TraceCommand, AVertexBehindTheEyeIsSaidInWords) {
  const ToolResult result = trace({"--point", "4,3.2,6.8"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("behind the eye by "));
  EXPECT_THAT(result.out, Not(HasSubstr("clip -> NDC")));
  EXPECT_THAT(result.out, Not(HasSubstr("nan")));
}

TEST_F(TraceCommand, LatexIsAWholeDocument) {
  const ToolResult result = trace({"--latex"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out_lines().front(), "\\documentclass[a4paper,landscape]{article}");
  EXPECT_EQ(result.out_lines().back(), "\\end{document}");
}

TEST_F(TraceCommand, RefusesInOneLine) {
  expect_one_line_error(trace({"--object", "pot"}), 2, "there is no object \"pot\"; there are \"solid\"");
  expect_one_line_error(trace({"--vertex", "24"}), 2, "its mesh has 24 vertices, 0 to 23");
  expect_one_line_error(trace({"--vertex", "-1"}), 2, "-1");
  expect_one_line_error(trace({"--point", "1,2"}), 2, "three numbers with commas between");
  expect_one_line_error(trace({"--point", "1,2,nan"}), 2, "finite");
  expect_one_line_error(trace({"--frame", "2000000"}), 2, "frame 2000000 is out of range");
  expect_one_line_error(trace({"--vectors", "diagonal"}), 2, "column");
  expect_one_line_error(trace({"--latex", "--json"}), 2, "--json");
  expect_one_line_error(trace({"--vertex", "1", "--point", "1,2,3"}), 2, "--vertex");
}

TEST_F(TraceCommand, GoesBackFromAPixel) {
  const ToolResult result = trace({"--pixel", "16,9"});
  EXPECT_EQ(result.code, 0) << result.err;
  for (const char* part : {"pixel -> ray", "ray -> hit: triangle ", "weight in the picture", "weight in space",
                           "why depth is -A - B / z", "pixel (16, 9): x and y"})
    EXPECT_THAT(result.out, HasSubstr(part));
  const std::vector<json> found = objects({"--pixel", "16,9"});
  EXPECT_EQ(found.front()["type"], "trace_pixel");
  EXPECT_EQ(found.back()["pixel"], json({16, 9}));
}

TEST_F(TraceCommand, APixelOfNothingSaysWhereObjectsAre) {
  expect_one_line_error(trace({"--pixel", "0,0"}), 2,
                        "pixel (0, 0): shows nothing at frame 0; vertices lie in columns ");
  expect_one_line_error(trace({"--pixel", "32,0"}), 2, "0,0 to 31,17 are in it");
  expect_one_line_error(trace({"--pixel", "1.5,0"}), 2, "two whole numbers");
  expect_one_line_error(trace({"--pixel", "1,0", "--vertex", "2"}), 2, "--vertex");
}

TEST_F(TraceCommand, AWindowOfNoAreaIsRefusedWithItsPlace) {
  plant("shot.toml", replaced(replaced(cube_shot(), "\"perspective\"", "\"orthographic\""), "fovy_degrees = 45.0",
                              "left = 1\nright = 1"));
  expect_one_line_error(trace({}), 65, "shot.toml:");
}

TEST_F(TraceCommand, A2dShotHasItsOwnPipeline) {
  const ToolResult result = run_tool({"trace", MORPHCL_SOURCE_DIR "/demos/floor_plan.toml"});
  EXPECT_EQ(result.code, 0) << result.err;
  for (const char* part : {"x, y of the plane are x, -z of the world", "world -> view: centre (0, 0)",
                           "view -> NDC: clipping window x -8 to 8", "NDC -> viewport: 1280 x 720"})
    EXPECT_THAT(result.out, HasSubstr(part));
}

// Every output of docs/trace.md: a block of text behind the indented command that printed it.
TEST_F(TraceCommand, PrintsWhatTheDocumentationShows) {
  std::ifstream file(MORPHCL_SOURCE_DIR "/docs/trace.md");
  const std::string start = "    morphcl trace ";
  std::string command, shown;
  int compared = 0;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(start)) command = line.substr(start.size());
    if (line == "```text") {
      inside = true;
      shown.clear();
    } else if (line == "```" && inside) {
      inside = false;
      std::istringstream words(command);
      std::vector<std::string> arguments = {"trace"};
      for (std::string word; words >> word;) arguments.push_back(word);
      EXPECT_EQ(run_tool(arguments, {.folder = MORPHCL_SOURCE_DIR}).out, shown) << command;
      ++compared;
    } else if (inside) {
      shown += line + "\n";
    }
  }
  EXPECT_GE(compared, 1);
}

}  // namespace
}  // namespace morphcl::cli_test
