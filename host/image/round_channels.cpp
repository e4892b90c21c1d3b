#include <vector>

#include "host/image/blank_spans.hpp"
#include "host/image/raw_frame.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

void round_depth(FrameBuffer& frame, double relative_error) {
  const int bits = mantissa_bits_for(relative_error);
  if (!frame.has_depth() || bits == float_mantissa_bits) return;
  const RawFrame memory(frame);  // the notes about blank blocks stay true, as those are left alone
  std::vector<PixelSpan> spans;
  for (int y = 0; y < frame.height(); ++y) {
    constexpr int side = FrameBuffer::block_side;
    if (y % side == 0) find_spans(spans, frame, y / side);
    std::byte* const row =
        memory.data + static_cast<std::size_t>(y) * memory.row_bytes + memory.plane_offset(Channel::depth, 0);
    for (const PixelSpan& span : spans)
      if (!span.blank)
        round_mantissas({reinterpret_cast<float*>(row) + span.first, span.count}, bits, background_depth);
  }
}

}  // namespace morphcl
