// The renderer that --device and --threads name.
#pragma once

#include <memory>
#include <string>

#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"

namespace morphcl::cli {

struct DeviceOptions {
  std::string device;  // "" the default, an index, part of a name, or "reference"
  int threads = 0;     // 0: what the process may use
};

struct OpenedRenderer {
  std::shared_ptr<Session> session;  // null for the reference renderer
  std::unique_ptr<Renderer> renderer;
  std::string device_name;
  int threads = 0;  // 0: not decided, one a CPU

  // Keeps what the device's compiler made for the next process; call it once a frame was rendered. May run beside a
  // render.
  void store_programs() const;

  // Says on stderr what kept store_programs() from doing so. For the end of a command.
  void warn_of_cache() const;
};

// Error(no_device) when there is none, or none of that name.
OpenedRenderer open_renderer(const DeviceOptions& options);

}  // namespace morphcl::cli
