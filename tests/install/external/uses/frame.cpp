#include <morphcl/frame.hpp>

bool use_frame() {
  morphcl::FrameBuffer frame(2, 1, {morphcl::Channel::color});
  frame.color_row(3, 0)[1] = 0x3c00;
  return morphcl::to_rgba32f(frame)[7] == 1.0f && morphcl::to_srgb8(frame)[7] == 255 &&
         morphcl::pixel_hash(frame).size() == 32;
}
