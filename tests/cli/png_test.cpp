// PNG frames as a user makes, resumes and looks at them.
#include <nlohmann/json.hpp>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using testing::HasSubstr;

class Png : public ToolTest {
 protected:
  ToolResult render(const std::string& shot, std::vector<std::string> options) {
    std::vector<std::string> arguments = {"render", plant("shot.toml", shot), "--device", "reference"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_tool(arguments, {.folder = folder_});
  }
};

// The shot asks for Z as every shot does that does not say otherwise: it is left out.
TEST_F(Png, IsRenderedResumedAndDescribed) {
  ToolResult result = render(cube_shot(), {"-o", "f.##.PNG", "--png-bits", "16", "--verify"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(files_ending_in(".PNG"), 5u);
  std::filesystem::remove(folder_ / "f.03.PNG");
  result = render(cube_shot(), {"-o", "f.##.PNG", "--png-bits", "16", "--resume"});
  EXPECT_THAT(result.out, HasSubstr("1 frame rendered, 4 kept"));

  const std::string table = run_tool({"info", path("f.03.PNG")}).out;
  EXPECT_THAT(table, HasSubstr("32 x 18"));
  EXPECT_THAT(table, HasSubstr("RGBA, 16 bits"));
  const nlohmann::json image = nlohmann::json::parse(run_tool({"info", path("f.03.PNG"), "--json"}).out_lines().at(0));
  EXPECT_EQ(image.at("frame"), 3);
  EXPECT_EQ(image.at("bits"), 16);
  EXPECT_EQ(image.at("hash"), image.at("stored_hash"));
  EXPECT_EQ(image.at("fingerprint").get<std::string>().size(), 32u);

  std::filesystem::resize_file(folder_ / "f.03.PNG", std::filesystem::file_size(folder_ / "f.03.PNG") - 20);
  expect_one_line_error(run_tool({"info", path("f.03.PNG")}), 65, "f.03.PNG");
}

TEST_F(Png, OfDepthAloneIsRefused) {
  const std::string shot = replaced(cube_shot(), "[image]\n", "[image]\nchannels = [\"Z\"]\n");
  expect_one_line_error(render(shot, {"-o", "f.##.png"}), 2, "RGBA");
  EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
}

TEST_F(Png, ExposureChangesTheirPixels) {
  const auto hash = [&](const std::string& name, const std::vector<std::string>& exposure) {
    std::vector<std::string> options = {"--frames", "0", "-o", name};
    options.insert(options.end(), exposure.begin(), exposure.end());
    EXPECT_EQ(render(cube_shot(), options).code, 0) << name;
    return nlohmann::json::parse(run_tool({"info", path(name), "--json"}).out_lines().at(0))
        .at("hash")
        .get<std::string>();
  };
  const std::string plain = hash("plain.png", {});
  EXPECT_EQ(hash("zero.png", {"--exposure", "0"}), plain);
  const std::string bright = hash("bright.png", {"--exposure", "+1"});
  EXPECT_NE(bright, plain);
  EXPECT_NE(hash("dark.png", {"--exposure", "-1.5"}), plain);
  EXPECT_EQ(hash("plain.png", {"--exposure", "1", "--resume"}), bright) << "drawn anew";
}

}  // namespace
}  // namespace morphcl::cli_test
