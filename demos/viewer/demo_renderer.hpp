// The renderer that a demo's --device and --threads name.
#pragma once

#include <memory>
#include <string>

#include "morphcl/renderer.hpp"
#include "morphcl/session.hpp"

namespace morphcl::viewer {

class DemoRenderer {
 public:
  // `device`: "auto", "reference", or as SessionOptions::device; for all but the reference the process is prepared
  // before (prepare_process). Throws what Session::open() throws.
  DemoRenderer(const std::string& device, int threads);
  DemoRenderer(const DemoRenderer&) = delete;
  DemoRenderer& operator=(const DemoRenderer&) = delete;
  // Where kernels are still being compiled, main() is to end by end_process() (host/end_process.hpp).
  ~DemoRenderer();

  // For the next frame of a demo, which goes on for long.
  Renderer& for_next_frame();

  // Keeps what was compiled, for the next start; for the end.
  void store_programs();

 private:
  std::shared_ptr<Session> session_;  // of a device that was named
  AutoRenderer* by_turns_ = nullptr;  // renderer_, where nothing was named
  std::unique_ptr<Renderer> renderer_;
};

}  // namespace morphcl::viewer
