#include <morphcl/png.hpp>

bool use_png() {
  const morphcl::FrameBuffer frame(4, 3, {morphcl::Channel::color});
  const std::string hash = morphcl::write_png("use_png.png", frame, {}, 16);
  return morphcl::describe_png("use_png.png").hash == hash && morphcl::read_png("use_png.png").frame.width() == 4;
}
