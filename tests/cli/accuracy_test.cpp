// morphcl accuracy as a user runs it.
#include <nlohmann/json.hpp>

#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using testing::HasSubstr;

class Accuracy : public ToolTest {
 protected:
  ToolResult run(std::vector<std::string> options, const ToolOptions& how = {}) {
    options.insert(options.begin(), "accuracy");
    return run_tool(options, how);
  }
};

TEST_F(Accuracy, PrintsALineAnOperationAndWritesTheFiles) {
  const ToolResult result = run({"--quick", "--operation", "lerp", "clip", "--device", "none", "--out", path("out")});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("device: none"));
  EXPECT_THAT(result.out, HasSubstr("no printed digit changes"));
  EXPECT_THAT(result.out, testing::ContainsRegex("\n  lerp +scaled +1\\.6 +2 +[0-9.]+ .* a \\+ t \\(b - a\\)\n"));
  EXPECT_THAT(result.out, testing::ContainsRegex("\n  clip +.* in the order given\n"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("is enough")));
  const nlohmann::json json = nlohmann::json::parse(test_support::text_of(path("out/accuracy.json")));
  EXPECT_EQ(json["operations"].size(), 2u);
  EXPECT_THAT(test_support::text_of(path("out/accuracy.csv")), HasSubstr("lerp,benign,"));
}

TEST_F(Accuracy, VerboseHasEveryVariant) {
  const ToolResult result = run({"--quick", "--operation", "lerp", "--device", "none", "--verbose"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("lerp: "));
  EXPECT_THAT(result.out, HasSubstr("is enough"));
  EXPECT_THAT(result.out, HasSubstr("(1 - t) a + t b"));
}

TEST_F(Accuracy, WithoutGnuplotTheOtherFilesComeAndOneLineSaysWhatIsMissing) {
  std::filesystem::create_directory(path("empty"));
  const ToolResult result = run({"--quick", "--operation", "lerp", "--device", "none", "--out", path("out")},
                                {.environment = {{"PATH", path("empty")}}});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("morphcl: no plots: gnuplot is not installed"));
  EXPECT_EQ(files(), (std::set<std::string>{"out/accuracy.csv", "out/accuracy.json"}));
}

TEST_F(Accuracy, AGnuplotThatFailsLeavesThePlotsOfBefore) {
  std::filesystem::create_directory(path("bin"));
  plant("bin/gnuplot", "#!/bin/sh\nread line\necho half > out/accuracy.svg.unfinished\nexit 1\n");
  std::filesystem::permissions(path("bin/gnuplot"), std::filesystem::perms::owner_all);
  std::filesystem::create_directory(path("out"));
  plant("out/accuracy.svg", "of before");
  const ToolResult result = run({"--quick", "--operation", "lerp", "--device", "none", "--out", path("out")},
                                {.environment = {{"PATH", path("bin")}}, .folder = folder_});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("morphcl: no plots: gnuplot failed"));
  EXPECT_EQ(test_support::text_of(path("out/accuracy.svg")), "of before");
  EXPECT_EQ(files(),
            (std::set<std::string>{"bin/gnuplot", "out/accuracy.csv", "out/accuracy.json", "out/accuracy.svg"}));
}

TEST_F(Accuracy, TheDeviceGivesTheHostsBits) {
  const ToolResult result = run({"--quick", "--operation", "point-transform", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  ASSERT_EQ(result.out_lines().size(), 2u);
  const nlohmann::json head = nlohmann::json::parse(result.out_lines()[0]);
  EXPECT_EQ(head["type"], "accuracy");
  EXPECT_NE(head["machine"]["device"], "");
  int on_device = 0;
  const nlohmann::json operation = nlohmann::json::parse(result.out_lines()[1]);
  for (const nlohmann::json& variant : operation["results"]) {
    if (!variant.contains("device_bits")) continue;
    EXPECT_EQ(variant["device_bits"], "same") << variant;
    EXPECT_EQ(variant["timings"].size(), 3u) << "host, kernel, kernel with transfer";
    ++on_device;
  }
  EXPECT_EQ(on_device, 3 * 6) << "six variants in three families";
}

TEST_F(Accuracy, UnknownOperationListsThemAll) {
  const ToolResult result = run({"--operation", "lerq", "--device", "none", "--out", path("out")});
  expect_one_line_error(result, 2, "'lerq' is no operation of the report");
  EXPECT_THAT(result.err, HasSubstr("point-transform"));
}

TEST_F(Accuracy, HostileNamesStayOnOneLine) {
  expect_one_line_error(run({"--operation", "a\nb\033[31m", "--device", "none"}), 2, "no operation");
}

TEST_F(Accuracy, BadOptionsAreUsageErrors) {
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--seed", "-1"},
                                             {"--seed", "18446744073709551616"},
                                             {"--seed", "one"},
                                             {"--operation"},
                                             {"--threads", "0"},
                                             {"--out"},
                                             {"--device", "reference"},
                                             {"surplus"}})
    expect_one_line_error(run(options), 2, options[0] == "surplus" ? "surplus" : options[0]);
}

TEST_F(Accuracy, AnUnknownDeviceIsNamed) {
  expect_one_line_error(run({"--quick", "--operation", "lerp", "--device", "no such device"}), 69, "no such device");
}

TEST_F(Accuracy, AFolderThatCannotBeMadeFailsBeforeAnythingIsMeasured) {
  plant("file", "");
  const ToolResult result = run({"--device", "none", "--out", path("file/out")});
  expect_one_line_error(result, 73, "file");
  EXPECT_EQ(files(), std::set<std::string>{"file"});
}

}  // namespace
}  // namespace morphcl::cli_test
