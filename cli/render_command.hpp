// morphcl render: frames of a shot or model into EXR or PNG files.
#pragma once

#include <optional>
#include <string>

#include "cli/open_renderer.hpp"
#include "cli/scene_options.hpp"

namespace morphcl::cli {

struct RenderOptions {
  SceneOptions scene;
  DeviceOptions device{.device = auto_name, .threads = 0};
  std::optional<std::string> pattern;   // absent: NAME.####.exr
  std::optional<std::string> png_bits;  // "8", "16"; absent: 8
  std::optional<std::string> frames;    // absent: the shot's range
  std::string explain;                  // folder for what the hidden-surface method did; "" none
  std::string contact_sheet;            // PNG of all frames; "" none
  std::optional<std::string> exposure;  // "-1.5"; absent: 0
  bool preview = false;                 // a PNG beside each frame
  bool resume = false;
  bool verify = false;
  // False: nothing is left out of the frames' plans and no frame is copied from an equal one; the pixels are the same.
  bool leave_out = true;
  bool json = false;
  bool quiet = false;
};

// Returns the exit code. Everything that the options and the scene can have wrong is found before the first frame.
int render_command(const RenderOptions& options);

}  // namespace morphcl::cli
