// The peer's command line: the options of all compared programs, and those of writing files.
//
//   --out FOLDER     write every frame there: SCENE.####.exr, half RGBA, ZIP
//   --zip-level N    of zlib, 1 to 9; default 1
//   --resolve HOW    of several samples: blit, by glBlitFramebuffer, or shader; default blit
//   --part K/N       draw frames K, K + N, K + 2 N, ... only; default 0/1
#pragma once

#include <optional>

#include "bench/options.hpp"

namespace morphcl::bench {

struct PeerOptions : Options {
  std::string out;  // a folder; "": no files
  int zip_level = 1;
  int part = 0, parts = 1;  // 0 <= part < parts
  bool resolve_by_shader = false;
};

// As parse_options().
std::optional<PeerOptions> parse_peer_options(int argc, char** argv);

}  // namespace morphcl::bench
