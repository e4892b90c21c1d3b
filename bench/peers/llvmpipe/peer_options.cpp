#include "bench/peers/llvmpipe/peer_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

void parse_part(const std::string& text, PeerOptions& options) {
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%4d/%4d%c", &options.part, &options.parts, &rest);
  if (read != 2 || options.part < 0 || options.part >= options.parts)
    throw Error(ErrorKind::usage, "", fmt::format("--part {}: write K/N, 0 <= K < N", printable(text)));
}

}  // namespace

std::optional<PeerOptions> parse_peer_options(int argc, char** argv) {
  PeerOptions options;
  std::string part, resolve = "blit";
  const auto parsed = parse_options(
      argc, argv, "Times OpenGL on llvmpipe on a scene: draw and read back to half RGBA; with --out, write it too.",
      [&](CLI::App& app) {
        app.add_option("--out", options.out, "folder for SCENE.####.exr; default: no files")
            ->check(CLI::ExistingDirectory);
        app.add_option("--zip-level", options.zip_level, "of zlib; default 1")->check(CLI::Range(1, 9));
        app.add_option("--resolve", resolve, "of several samples: blit or shader; default blit")
            ->check(CLI::IsMember({"blit", "shader"}));
        app.add_option("--part", part, "K/N: only frames K, K + N, K + 2 N, ...; default: all");
      });
  if (!parsed) return std::nullopt;
  static_cast<Options&>(options) = *parsed;
  options.resolve_by_shader = resolve == "shader";
  if (!part.empty()) parse_part(part, options);
  return options;
}

}  // namespace morphcl::bench
