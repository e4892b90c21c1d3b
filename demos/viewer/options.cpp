#include "demos/viewer/options.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>

#include "morphcl/error.hpp"

namespace morphcl::viewer {
namespace {

constexpr int kLargestSize = 16384;

Size parse_size(const std::string& text) {
  Size size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool has_cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = std::from_chars(has_cross ? width.ptr + 1 : end, end, size.height);
  const auto in_range = [](int pixels) { return pixels >= 1 && pixels <= kLargestSize; };
  if (!has_cross || height.ec != std::errc() || height.ptr != end || !in_range(size.width) || !in_range(size.height)) {
    throw Error(ErrorKind::usage, "--size",
                fmt::format("\"{}\" is no size; give WIDTHxHEIGHT with 1 to {} pixels each, as in 640x480",
                            printable(text), kLargestSize));
  }
  return size;
}

std::string footer(bool turns) {
  std::string text = "Keys (held down, those that move go on moving):\n";
  for (const KeyInfo& entry : key_table()) {
    if (entry.name.empty() || (entry.needs_turn && !turns)) continue;
    const std::string names =
        entry.alias.empty() ? std::string(entry.name) : fmt::format("{} {}", entry.name, entry.alias);
    text += fmt::format("  {:<7}{}\n", names, entry.does);
  }
  text += "The mouse turns the scene with the left button down; the wheel brings it nearer.\n";
  return text +
         fmt::format(
             "\nA script is a comma list of presses, each a key of this table with an optional count from 1 to {}:\n"
             "  --script k37,o,w3,e\n"
             "presses k 37 times, o, w three times and e. While the animation plays (space), a script waits for its\n"
             "last frame. With a window, the keyboard goes on where the script ends; end it with esc to leave.\n",
             kMaxPresses);
}

bool exports_a_frame(const std::vector<KeyPress>& script) {
  return std::ranges::any_of(script, [](const KeyPress& press) { return press.key == Key::export_frame; });
}

void check_output(const DemoOptions& options) {
  if (!options.headless) {
    if (!options.out.empty()) {
      throw Error(ErrorKind::usage, "--out", "needs --headless; in the window the key e exports the frame");
    }
    return;
  }
  if (options.out.empty() && !exports_a_frame(options.script)) {
    throw Error(ErrorKind::usage, "--headless",
                "nothing would be written; give --out FILE.exr, --out FILE.png or a --script with e");
  }
  const std::string extension = std::filesystem::path(options.out).extension().string();
  if (!options.out.empty() && extension != ".exr" && extension != ".png") {
    throw Error(ErrorKind::usage, "--out", fmt::format("\"{}\" ends in neither .exr nor .png", printable(options.out)));
  }
}

}  // namespace

std::optional<DemoOptions> parse_options(const DemoSettings& settings, const DemoSettings* deck, int argc,
                                         const char* const* argv) {
  DemoOptions options;
  std::string script, size;
  CLI::App app(settings.description, settings.name);
  app.footer(footer(settings.turning || (deck && deck->turning)));
  if (deck) app.add_flag("--deck", options.deck, deck->description);
  app.add_option("--size", size, "Size of the picture, pixels")
      ->option_text(fmt::format("WxH [{}x{}]", settings.width, settings.height));
  app.add_option("--shot", options.shot, "Show another shot file or model")
      ->option_text("FILE [" + settings.shot + "]");
  app.add_option(
         "--device", options.device,
         "OpenCL device: part of its name, its index, or \"reference\"; \"auto\": the reference, until the kernels "
         "are compiled")
      ->option_text("NAME [auto]");
  app.add_option("--threads", options.threads, "Threads of the renderer; 0: all that this process may use")
      ->option_text("N [0]")
      ->check(CLI::Range(0, 4096));
  app.add_option("--script", script, "Press these keys")->option_text("SCRIPT");
  app.add_flag("--headless", options.headless, "Open no window: run the script and end");
  app.add_option(
         "--out", options.out,
         "With --headless: write the last frame, as EXR or (with what h shows) as PNG; # in the name stands for "
         "digits of the frame number")
      ->option_text("FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorKind::usage, "", fmt::format("{}; see --help", printable(error.what())));
  }
  const DemoSettings& chosen = options.deck ? *deck : settings;
  options.size = size.empty() ? Size{chosen.width, chosen.height} : parse_size(size);
  if (app.count("--script") > 0) options.script = parse_key_script(script);
  check_output(options);
  return options;
}

}  // namespace morphcl::viewer
