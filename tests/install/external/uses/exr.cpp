#include <morphcl/exr.hpp>

bool use_exr() {
  const morphcl::FrameBuffer frame(4, 3, {morphcl::Channel::color, morphcl::Channel::depth});
  const std::string hash = morphcl::write_exr("use_exr.exr", frame);
  return morphcl::read_exr("use_exr.exr").hash == hash && morphcl::describe_exr("use_exr.exr").channels.size() == 5;
}
