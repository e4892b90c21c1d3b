// The texts of options: frame ranges, output patterns, sizes, rates, names.
#include "cli/option_values.hpp"
#include "host/job/frame_pattern.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace morphcl;
  using namespace morphcl::fuzz;
  const std::string text(text_of(data, size));
  may_refuse([&] { frame_numbers(parse_frame_range(text)); });
  may_refuse([&] {
    const FramePattern pattern(text);
    demand(!pattern.has_number() || pattern.path(7) != pattern.path(8), "frames have names of their own");
  });
  may_refuse([&] { cli::parse_size(text); });
  may_refuse([&] { cli::parse_fps(text); });
  may_refuse([&] { cli::parse_seed(text); });
  ImageSettings image;
  may_refuse([&] { cli::set_channels(text, image); });
  may_refuse([&] { cli::set_channel_names(text, image); });
  may_refuse([&] { cli::set_compression(text, image); });
  may_refuse([&] { cli::set_depth_buffer(text, image); });
  image.channels = every_channel;
  may_refuse([&] {
    cli::set_z_error(text, image);
    demand(image.z_error > 0 && image.z_error <= 0.1, "an error bound in range");
  });
  may_refuse([&] {
    cli::set_n_error(text, image);
    demand(image.n_error > 0 && image.n_error <= 0.1, "an error bound in range");
  });
  return 0;
}
