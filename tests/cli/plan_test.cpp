// What morphcl plan prints, and that leaving nothing out changes no pixel.
#include <nlohmann/json.hpp>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Plan : public ToolTest {
 protected:
  Plan() { plant("shot.toml", cube_shot()); }

  std::map<int, std::string> hashes(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"render", path("shot.toml"), "--device", "reference", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ToolResult result = run_tool(arguments, {.folder = folder_});
    EXPECT_EQ(result.code, 0) << result.err;
    std::map<int, std::string> found;  // by frame
    for (const std::string& line : result.out_lines())
      if (const json object = json::parse(line); object.contains("hash")) found[object["frame"]] = object["hash"];
    return found;
  }
};

TEST_F(Plan, EndsWithTheFramesCostAndMemory) {
  const ToolResult table = run_tool({"plan", path("shot.toml")});
  EXPECT_THAT(table.out, HasSubstr(" ms to draw"));
  EXPECT_THAT(table.out, HasSubstr("memory: device "));
  EXPECT_THAT(table.out, Not(HasSubstr("too large")));
  const ToolResult result = run_tool({"plan", path("shot.toml"), "--json"});
  ASSERT_FALSE(result.out.empty());
  double largest_share = 0;
  for (const std::string& line : result.out_lines())
    if (const json note = json::parse(line); note["type"] == "plan")
      largest_share = std::max(largest_share, note.at("share").get<double>());
  EXPECT_GT(largest_share, 0);
  const json total = json::parse(result.out_lines().back());
  EXPECT_EQ(total.at("type"), "plan_total");
  EXPECT_GT(total.at("estimated_ms"), 0);
  EXPECT_GT(total.at("pixel_bytes"), 0);
  EXPECT_EQ(total.at("exceeds_device"), "");
}

TEST_F(Plan, NoneLeavesNothingOutAndGivesTheSamePixels) {
  const ToolResult usual = run_tool({"plan", path("shot.toml")});
  const ToolResult none = run_tool({"plan", path("shot.toml"), "--plan", "none"});
  EXPECT_THAT(usual.out, Not(HasSubstr("nothing is to be left out")));
  EXPECT_THAT(none.out, HasSubstr("nothing is to be left out"));
  const std::map<int, std::string> expected = hashes({"--plan", "auto"});
  ASSERT_EQ(expected.size(), 5u);
  EXPECT_EQ(hashes({"--plan", "none"}), expected);
}

TEST_F(Plan, AnUnknownChoiceIsRefused) {
  expect_one_line_error(run_tool({"plan", path("shot.toml"), "--plan", "some"}), 2, "--plan");
  expect_one_line_error(run_tool({"render", path("shot.toml"), "--plan", "1"}), 2, "--plan");
}

// PoCL calls itself a device of 1 GiB then, and allocates a quarter of it at once.
TEST_F(Plan, SaysWhenAFrameIsTooLargeForTheDevice) {
  plant("huge.toml", "[image]\nsize = [64, 48]\n[[object]]\nmesh = \"sphere_to_cube\"\nsegments = [3032, 3032]\n");
  const ToolOptions small_device{.environment = {{"POCL_MEMORY_LIMIT", "1"}}};
  const ToolResult result = run_tool({"plan", path("huge.toml")}, small_device);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("too large: vertices and morph targets of the meshes need 263."));
  EXPECT_THAT(result.out, HasSubstr("the device allocates at most 256.0 MiB"));
}

}  // namespace
}  // namespace morphcl::cli_test
