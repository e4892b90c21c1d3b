// --visibility and --explain: the same pixels by every method, what is written about each, and what is refused.
#include <nlohmann/json.hpp>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Visibility : public ToolTest {
 protected:
  Visibility() { plant("shot.toml", cube_shot()); }

  json explained(const std::string& method) {
    const ToolResult result = run_tool(
        {"plan", path("shot.toml"), "--frame", "2", "--json", "--visibility", method, "--explain", path("why")});
    EXPECT_EQ(result.code, 0) << result.err;
    return json::parse(result.out_lines().back());
  }
};

TEST_F(Visibility, EveryMethodRendersTheSamePixels) {
  std::set<std::string> hashes;
  for (const char* method : {"z-buffer", "painter", "bsp", "warnock", "watkins"}) {
    const ToolResult result =
        run_tool({"render", path("shot.toml"), "--frames", "2", "--json", "--visibility", method}, {.folder = folder_});
    EXPECT_EQ(result.code, 0) << result.err;
    for (const std::string& line : result.out_lines())
      if (const json object = json::parse(line); object.contains("hash")) hashes.insert(object["hash"]);
  }
  EXPECT_EQ(hashes.size(), 1u);
}

TEST_F(Visibility, AShotMayName) {
  plant("bsp.toml", replaced(cube_shot(), "[image]\n", "[image]\nvisibility = \"bsp\"\n"));
  const ToolResult result = run_tool({"plan", path("bsp.toml")});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("bsp is asked for: it parts space by planes"));
  EXPECT_THAT(result.out, HasSubstr("the reference draws all frames"));
}

TEST_F(Visibility, ExplanationOfEachMethod) {
  const std::map<std::string, std::set<std::string>> expected = {
      {"z-buffer", {"numbers.json", "overdraw.png"}},
      {"painter", {"numbers.json", "overdraw.png", "order.csv", "order.png", "within_error.csv"}},
      {"bsp", {"numbers.json", "overdraw.png", "order.csv", "order.png", "tree.txt", "tree.dot", "within_error.csv"}},
      {"warnock", {"numbers.json", "overdraw.png", "windows.csv", "quadtree.png", "within_error.csv"}},
      {"watkins", {"numbers.json", "overdraw.png", "spans.csv", "spans.png", "within_error.csv"}}};
  for (const auto& [method, names] : expected) {
    SCOPED_TRACE(method);
    const json object = explained(method);
    EXPECT_EQ(object.at("type"), "explanation");
    EXPECT_EQ(object.at("visibility"), method);
    EXPECT_EQ(object.at("counts").at("pixels that differ from the z-buffer"), 0);
    EXPECT_GT(object.at("counts").at("pixels covered"), 0);
    std::set<std::string> written;
    for (const std::string name : object.at("files")) {
      EXPECT_TRUE(std::filesystem::is_regular_file(path("why/" + name))) << name;
      EXPECT_EQ(name.find(method + ".0002."), 0u);
      written.insert(name.substr(method.size() + 6));
    }
    EXPECT_EQ(written, names);
  }
}

TEST_F(Visibility, RenderExplainsItsFrames) {
  const ToolResult result = run_tool(
      {"render", path("shot.toml"), "--frames", "1-3x2", "--visibility", "watkins", "--explain", "why", "--quiet"},
      {.folder = folder_});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(files_ending_in("spans.png"), 2u);
}

TEST_F(Visibility, WhatIsRefused) {
  const std::string shot = path("shot.toml");
  expect_one_line_error(run_tool({"render", shot, "--visibility", "warnok"}), 2, "did you mean \"warnock\"?");
  expect_one_line_error(
      run_tool({"render", shot, "--visibility", "bsp", "--samples", "4"}), 2,
      "--visibility: visibility bsp takes one sample a pixel, not 4; ask for samples 1, or for z-buffer");
  expect_one_line_error(run_tool({"render", shot, "--visibility", "bsp", "--device", "0"}), 2, "--device reference");
  plant("samples.toml", replaced(cube_shot(), "[image]\n", "[image]\nvisibility = \"painter\"\nsamples = 4\n"));
  expect_one_line_error(run_tool({"render", path("samples.toml")}), 65, "takes one sample a pixel, not 4");
}

}  // namespace
}  // namespace morphcl::cli_test
