#include "bench/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <thread>

#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

constexpr int max_side = 16384;

void parse_size(const std::string& text, Options& options) {
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%5dx%5d%c", &options.width, &options.height, &rest);
  if (read != 2 || options.width < 1 || options.height < 1 || options.width > max_side || options.height > max_side)
    throw Error(ErrorKind::usage, "",
                fmt::format("--size {}: write WIDTHxHEIGHT in pixels, each from 1 to {}", printable(text), max_side));
}

}  // namespace

std::optional<Options> parse_options(int argc, char** argv, const std::string& description,
                                     const std::function<void(CLI::App&)>& add_options) {
  Options options;
  options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::string size;
  CLI::App app(description);
  app.add_option("SCENE", options.scene)->required();
  app.add_option("--amount", options.amount, "triangles, layers or objects; default: the scene's own number")
      ->check(CLI::Range(1, 1'000'000'000));
  app.add_option("--frames", options.frames, "timed frames; default: the scene's own number")
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--threads", options.threads, "threads that draw; default: one a processor")
      ->check(CLI::Range(1, 4096));
  app.add_option("--samples", options.samples, "a pixel; default: 1")->check(CLI::IsMember({1, 2, 4, 8, 16}));
  app.add_option("--size", size, "WIDTHxHEIGHT in pixels; default: the scene's own");
  if (add_options) add_options(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw Error(ErrorKind::usage, "", error.what());
    app.exit(error);
    return std::nullopt;
  }
  if (!size.empty()) parse_size(size, options);
  return options;
}

}  // namespace morphcl::bench
