// The renderer that --device and --threads name.
#pragma once

#include <memory>
#include <string>

#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"

namespace morphcl::cli {

// What renderers are named by that are no device.
inline constexpr const char* reference_name = "reference";
inline constexpr const char* auto_name = "auto";

struct DeviceOptions {
  std::string device;  // "" the default device, an index, part of a name, "reference" or "auto"
  int threads = 0;     // 0: what the process may use
};

struct OpenedRenderer {
  OpenedRenderer() = default;
  OpenedRenderer(OpenedRenderer&&) = default;
  // An auto renderer whose thread is at work is left as it is: the process is to end by end_process().
  ~OpenedRenderer();

  std::shared_ptr<Session> session;  // null unless a device was named
  std::unique_ptr<Renderer> renderer;
  AutoRenderer* by_turns = nullptr;  // the renderer, where it is an auto renderer
  std::string device_name;
  int threads = 0;  // 0: not decided, one a CPU

  // Keeps what the device's compiler made for the next process; call it once a frame was rendered. May run beside a
  // render of a named device; of an auto renderer it is for the end.
  void store_programs() const;

  // Says on stderr what kept store_programs() from doing so. For the end of a command.
  void warn_of_cache() const;

  // Why no device took part where one could have: "", or in one line.
  std::string note() const;
};

// Error(no_device) when there is none, or none of that name.
OpenedRenderer open_renderer(const DeviceOptions& options);

}  // namespace morphcl::cli
