#include "host/render/frame/require_fit.hpp"

#include <fmt/format.h>

#include "host/error.hpp"

namespace morphcl {

namespace {

std::string shape(int width, int height, bool color, bool depth) {
  const char* const channels = color ? depth ? "RGBA and Z" : "RGBA alone" : depth ? "Z alone" : "no channels";
  return fmt::format("{} x {} pixels of {}", width, height, channels);
}

}  // namespace

void require_fit(const FramePlan& plan, const FrameBuffer& frame) {
  if (frame.width() == plan.width && frame.height() == plan.height && frame.has_color() == plan.color &&
      frame.has_depth() == plan.depth)
    return;
  throw Error(ErrorKind::usage, "",
              fmt::format("the plan draws {}, but the frame buffer has {}",
                          shape(plan.width, plan.height, plan.color, plan.depth),
                          shape(frame.width(), frame.height(), frame.has_color(), frame.has_depth())));
}

}  // namespace morphcl
