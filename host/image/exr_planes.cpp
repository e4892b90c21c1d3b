#include "host/image/exr_planes.hpp"

namespace morphcl {

namespace {

template <class Frame>
Imf::FrameBuffer slices_on(Frame& frame, int first_x, int first_y) {
  const Imath::Box2i window({first_x, first_y}, {first_x + frame.width() - 1, first_y + frame.height() - 1});
  Imf::FrameBuffer slices;
  const auto insert = [&](const char* name, Imf::PixelType type, auto first_row, double missing) {
    slices.insert(
        name, Imf::Slice::Make(type, first_row.data(), window, sizeof first_row[0], frame.row_bytes(), 1, 1, missing));
  };
  if (frame.has_color())
    for (int channel = 0; channel < 4; ++channel)
      insert(color_channel_names[static_cast<std::size_t>(channel)], Imf::HALF, frame.color_row(channel, 0),
             channel == 3 ? 1.0 : 0.0);
  if (frame.has_depth()) insert(depth_channel_name, Imf::FLOAT, frame.depth_row(0), 0.0);
  return slices;
}

}  // namespace

Imf::FrameBuffer planes_of(FrameBuffer& frame, int first_x, int first_y) { return slices_on(frame, first_x, first_y); }

Imf::FrameBuffer planes_to_write(const FrameBuffer& frame) { return slices_on(frame, 0, 0); }

}  // namespace morphcl
