// What is wrong on the command line itself: exit code 2, one line, nothing written.
#include <cstdlib>
#include <sstream>

#include "tests/cli/cube_shot.hpp"
#include "tests/cli/expectations.hpp"
#include "tests/cli/tool_test.hpp"

namespace morphcl::cli_test {
namespace {

using testing::HasSubstr;

class Usage : public ToolTest {
 protected:
  void expect_usage_error(std::vector<std::string> options, const std::string& part) {
    std::vector<std::string> arguments = {"render", plant("shot.toml", cube_shot()), "--device", "reference"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_one_line_error(run_tool(arguments, {.folder = folder_}), 2, part);
    EXPECT_EQ(files(), std::set<std::string>{"shot.toml"});
  }
};

TEST_F(Usage, NoCommand) { expect_one_line_error(run_tool({}), 2, "a command is missing, as in morphcl render"); }
TEST_F(Usage, UnknownCommand) { expect_one_line_error(run_tool({"paint"}), 2, "paint"); }
TEST_F(Usage, NoScene) { expect_one_line_error(run_tool({"render"}), 2, "SCENE"); }
TEST_F(Usage, UnknownOption) { expect_usage_error({"--colour"}, "--colour"); }
TEST_F(Usage, OptionWithoutItsValue) { expect_usage_error({"--size"}, "--size"); }
TEST_F(Usage, OptionGivenTwice) { expect_usage_error({"--size", "4x4", "--size", "8x8"}, "--size"); }
TEST_F(Usage, SizeZero) { expect_usage_error({"--size", "0x18"}, "--size: '0x18'"); }
TEST_F(Usage, SizeAbsurd) { expect_usage_error({"--size", "16385x1"}, "16384"); }
TEST_F(Usage, SizeOverflows) { expect_usage_error({"--size", "99999999999999999999x1"}, "--size"); }
TEST_F(Usage, SizeWithoutHeight) { expect_usage_error({"--size", "640"}, "WIDTHxHEIGHT"); }
TEST_F(Usage, FramesBackwards) { expect_usage_error({"--frames", "5-1"}, "5-1"); }
TEST_F(Usage, FramesWithColon) { expect_usage_error({"--frames", "1-10:2"}, ":"); }
TEST_F(Usage, FramesColonAlone) { expect_usage_error({"--frames", ":"}, ":"); }
TEST_F(Usage, FramesEmptyPart) { expect_usage_error({"--frames", "1,,2"}, "1,,2"); }
TEST_F(Usage, FramesNotNumbers) { expect_usage_error({"--frames", "all"}, "all"); }
TEST_F(Usage, FramesTooMany) { expect_usage_error({"--frames", "0-99999999999"}, "99999999999"); }
TEST_F(Usage, FpsZero) { expect_usage_error({"--fps", "0"}, "--fps"); }
TEST_F(Usage, FpsDividedByZero) { expect_usage_error({"--fps", "25/0"}, "--fps"); }
TEST_F(Usage, ThreadsZero) { expect_usage_error({"--threads", "0"}, "--threads"); }
TEST_F(Usage, ThreadsAbsurd) { expect_usage_error({"--threads", "100000"}, "1024"); }
TEST_F(Usage, UnknownCompression) {
  expect_usage_error({"--compression", "lzma"}, "known: none, rle, zips, zip, zip:small, piz, ");
}
TEST_F(Usage, SamplesThatAreNoPattern) {
  for (const char* samples : {"3", "0", "32", "-4", "4x", ""})
    expect_usage_error({"--samples", samples}, "1, 2, 4, 8 or 16");
}
TEST_F(Usage, UnknownVisibility) { expect_usage_error({"--visibility", "raster"}, "z-buffer"); }
TEST_F(Usage, UnknownDepthBuffer) { expect_usage_error({"--depth-buffer", "stencil"}, "fixed24"); }
TEST_F(Usage, ZErrorZero) { expect_usage_error({"--z-error", "0"}, "--z-error: '0' is no relative error of Z"); }
TEST_F(Usage, ZErrorNegative) { expect_usage_error({"--z-error=-1e-6"}, "above 0 and of at most 0.1, such as 1e-6"); }
TEST_F(Usage, ZErrorTooLarge) { expect_usage_error({"--z-error", "0.11"}, "at most 0.1"); }
TEST_F(Usage, ZErrorThatIsNan) { expect_usage_error({"--z-error", "nan"}, "at most 0.1"); }
TEST_F(Usage, ZErrorWithAUnit) { expect_usage_error({"--z-error", "1%"}, "'1%'"); }
TEST_F(Usage, ZErrorWithoutZ) {
  expect_usage_error({"--z-error", "1e-6", "--channels", "RGBA"}, "--z-error: is of channel Z, which is not among");
}
TEST_F(Usage, PErrorWithoutP) {
  expect_usage_error({"--p-error", "1e-6"},
                     "--p-error: is of channel P, which is not among the channels; --channels RGBA,P");
}
TEST_F(Usage, NErrorTooLarge) { expect_usage_error({"--n-error", "0.2"}, "'0.2' is no absolute error of N"); }
TEST_F(Usage, ZErrorOfPng) { expect_usage_error({"-o", "a.#.png", "--z-error", "1e-6"}, "--z-error: "); }
TEST_F(Usage, UnknownChannel) { expect_usage_error({"--channels", "RGB"}, "'RGB' is no channel"); }
TEST_F(Usage, EmptyChannel) { expect_usage_error({"--channels", "RGBA,"}, "--channels"); }
TEST_F(Usage, ChannelThatIsNearlyOne) {
  expect_usage_error({"--channels", "RGBA,velocty"}, "--channels: 'velocty' is no channel; did you mean \"velocity\"?");
}
TEST_F(Usage, ChannelTwice) { expect_usage_error({"--channels", "Z,N,Z"}, "--channels: 'Z' is named twice"); }
TEST_F(Usage, UnknownChannelNames) {
  expect_usage_error({"--channel-names", "houdini"}, "--channel-names: 'houdini' is no choice of names; known: plain");
}
TEST_F(Usage, LossyIds) {
  expect_usage_error({"--channels", "RGBA,crypto_material", "--compression", "pxr24"},
                     "--compression: the compression pxr24 is lossy, and crypto_material holds ids");
}
TEST_F(Usage, PatternWithoutNumber) { expect_usage_error({"-o", "out.exr"}, "out.exr"); }
TEST_F(Usage, PatternWithTwoNumbers) { expect_usage_error({"-o", "a.####.%04d.exr"}, "a.####.%04d.exr"); }
TEST_F(Usage, PatternOfAVideo) { expect_usage_error({"-o", "out.mp4"}, "ffmpeg"); }
TEST_F(Usage, PatternOfAnotherPicture) { expect_usage_error({"-o", "a.####.jpg"}, "'a.####.png'"); }
TEST_F(Usage, PatternWithoutEnding) { expect_usage_error({"-o", "a.####"}, "'a.####.exr'"); }
TEST_F(Usage, PngBitsOfNoPng) { expect_usage_error({"-o", "a.#.png", "--png-bits", "12"}, "8 or 16"); }
TEST_F(Usage, PngBitsOfExr) { expect_usage_error({"--png-bits", "16"}, "--png-bits: "); }
TEST_F(Usage, PngWithDepth) { expect_usage_error({"-o", "a.#.png", "--channels", "RGBA,Z"}, "--channels RGBA"); }
TEST_F(Usage, PngWithNormals) { expect_usage_error({"-o", "a.#.png", "--channels", "RGBA,N"}, "--channels RGBA"); }
TEST_F(Usage, PngWithChannelNames) { expect_usage_error({"-o", "a.#.png", "--channel-names", "nuke"}, "PNG frames"); }
TEST_F(Usage, PngWithCompression) { expect_usage_error({"-o", "a.#.png", "--compression", "zip"}, "--compression: "); }
TEST_F(Usage, PngWithPreview) { expect_usage_error({"-o", "a.#.png", "--preview"}, "--preview: "); }
TEST_F(Usage, ExposureOfNoNumber) { expect_usage_error({"--exposure", "bright"}, "--exposure: 'bright' is no"); }
TEST_F(Usage, ExposureThatIsInfinite) { expect_usage_error({"--exposure", "inf"}, "-30 to 30"); }
TEST_F(Usage, ExposureThatIsNan) { expect_usage_error({"--exposure", "nan"}, "-30 to 30"); }
TEST_F(Usage, ExposureOutOfRange) { expect_usage_error({"--exposure", "-30.5"}, "-30 to 30"); }
TEST_F(Usage, ExposureWithAUnit) { expect_usage_error({"--exposure", "2EV"}, "-30 to 30"); }
TEST_F(Usage, UnknownView) {
  expect_usage_error({"--view", "side"}, "three_quarter, front, back, left, right, top, bottom");
}
TEST_F(Usage, ViewAndCamera) { expect_usage_error({"--view", "left", "--camera", "0"}, "--view"); }
TEST_F(Usage, ControlCharactersStayOnOneLine) { expect_usage_error({"--size", "1\n2\033[31m"}, "--size"); }

TEST_F(Usage, ANearMissIsNamed) {
  expect_usage_error({"--frame", "3"}, "'--frame' is no option of morphcl render; did you mean \"--frames\"?");
  expect_usage_error({"--frame=3"}, "did you mean \"--frames\"?");
  expect_usage_error({"-frames", "3"}, "did you mean \"--frames\"?");
  expect_usage_error({"--resum"}, "did you mean \"--resume\"?");
  expect_usage_error({"--compression", "zpi"}, "'zpi' is no compression; did you mean \"zip\"?");
  expect_usage_error({"--depth-buffer", "fixed23"}, "did you mean \"fixed24\"?");
  expect_usage_error({"--fps", "29.97"}, "--fps: '29.97' is no exact frame rate; a ratio says it: 30000/1001");
  expect_one_line_error(run_tool({"rendr", "shot.toml"}), 2,
                        "'rendr' is no command of morphcl; did you mean \"render\"?");
  expect_one_line_error(run_tool({"a/shot.toml"}), 2, "did you mean morphcl render a/shot.toml?");
  expect_one_line_error(run_tool({"plan", "shot.toml", "--frames", "3"}), 2, "did you mean \"--frame\"?");
}

// As other programs call it, or another command.
TEST_F(Usage, ASynonymIsNamed) {
  expect_usage_error({"--out", "a.#.exr"}, "'--out' is no option of morphcl render; did you mean \"--output\"?");
  expect_usage_error({"--width=640"}, "did you mean \"--size\"?");
  expect_usage_error({"-f", "3"}, "did you mean \"--frames\"?");
  expect_usage_error({"--spp", "4"}, "did you mean \"--samples\"?");
  expect_one_line_error(run_tool({"compare", "shot.toml", "--output", "a"}), 2, "did you mean \"--out\"?");
  expect_one_line_error(run_tool({"info", "a.exr", "--jobs", "3"}), 2,
                        "'--jobs' is no option of morphcl info; known: ");
}

// The lines of a help text that begin as a command line does.
std::vector<std::string> examples_in(const std::string& help) {
  std::vector<std::string> examples;
  std::istringstream stream(help);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("  morphcl ")) examples.push_back(line.substr(2));
  return examples;
}

// As typed in the repository's folder, one after the other, as a reader tries them.
TEST_F(Usage, TheExamplesOfEveryHelpWork) {
  std::filesystem::create_directory_symlink(MORPHCL_SOURCE_DIR "/demos", folder_ / "demos");
  const std::string search = std::filesystem::path(MORPHCL_TOOL).parent_path().string() + ":" + std::getenv("PATH");
  for (const char* command : {"", "render", "plan", "trace", "compare", "info", "devices", "warm", "accuracy"}) {
    const std::vector<std::string> examples =
        examples_in(*command ? run_tool({command, "--help"}).out : run_tool({"--help"}).out);
    EXPECT_GE(examples.size(), 2u) << command;
    EXPECT_LE(examples.size(), 4u) << command;
    for (const std::string& example : examples) {
      EXPECT_LE(example.size(), 118u) << example;
      EXPECT_THAT(example, HasSubstr(command));
      const ToolResult result =
          test_support::run_process({"/bin/sh", "-c", example}, {.environment = {{"PATH", search}}, .folder = folder_});
      EXPECT_EQ(result.code, 0) << example << ": " << result.err;
      EXPECT_NE(result.out + result.err, "") << example;
    }
  }
}

TEST(Help, IsOnStdoutWithCodeZero) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{{"--help"},
                                                                                         {"render", "--help"},
                                                                                         {"plan", "-h"},
                                                                                         {"info", "--help"},
                                                                                         {"devices", "--help"},
                                                                                         {"warm", "--help"}}) {
    const ToolResult result = run_tool(arguments);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("Usage: morphcl"));
  }
}

TEST(Help, OfRenderNamesEveryOptionOfTheContractWithItsGroup) {
  const std::string help = run_tool({"render", "--help"}).out;
  for (const char* option :
       {"--output",        "--frames",  "--size",     "--channels",     "--compression", "--device",
        "--threads",       "--resume",  "--png-bits", "--verify",       "--json",        "--quiet",
        "--contact-sheet", "--preview", "--exposure", "--z-error",      "--p-error",     "--n-error",
        "--channel-names", "--view",    "--fps",      "--allow-outside"})
    EXPECT_THAT(help, HasSubstr(option));
  for (const char* group : {"Image:", "Time:", "Output:", "Device:", "Report:", "Input:"})
    EXPECT_THAT(help, HasSubstr(group));
}

TEST(Version, IsTheProjectsOnOneLine) {
  const ToolResult result = run_tool({"--version"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out, "morphcl " MORPHCL_VERSION "\n");
}

}  // namespace
}  // namespace morphcl::cli_test
