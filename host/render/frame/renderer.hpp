// A renderer turns a frame plan into pixels. Two exist and give the same bits: DeviceRenderer (OpenCL) and
// ReferenceRenderer (plain C++ loops).
#pragma once

#include <memory>
#include <string>

#include "host/image/frame_buffer.hpp"
#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

class Renderer {
 public:
  virtual ~Renderer() = default;
  // Draws the planned frame. Error(usage) when `frame` has another size or other channels than the plan. May be called
  // again with another plan of the same scene; buffers are kept between calls. Blocks until the pixels are in host
  // memory.
  virtual void render(const FramePlan& plan, FrameBuffer& frame) = 0;
  virtual std::string name() const = 0;
};

}  // namespace morphcl
