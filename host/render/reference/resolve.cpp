#include "host/render/reference/resolve.hpp"

#include <Imath/half.h>

#include <cmath>

#include "host/render/frame/sample_pattern.hpp"

namespace morphcl::reference {

namespace {

// The part of a pixel that shows one primitive.
struct Part {
  int samples = 0;
  int sum_x = 0, sum_y = 0;  // of the samples' offsets, sub-pixels

  SubPixelOffset centroid() const { return {mean(sum_x), mean(sum_y)}; }

 private:
  int mean(int sum) const {
    return static_cast<int>(std::nearbyint(static_cast<float>(sum) / static_cast<float>(samples)));
  }
};

Part part_of(std::span<const Sample> samples, std::uint64_t order) {
  const std::span<const SampleOffset> pattern = sample_pattern(static_cast<int>(samples.size()));
  Part part;
  for (std::size_t s = 0; s < samples.size(); ++s)
    if (samples[s].order == order) {
      ++part.samples;
      part.sum_x += pattern[s].subpixels_x();
      part.sum_y += pattern[s].subpixels_y();
    }
  return part;
}

bool is_first(std::span<const Sample> samples, std::size_t s) {
  for (std::size_t before = 0; before < s; ++before)
    if (samples[before].order == samples[s].order) return false;
  return true;
}

}  // namespace

std::array<std::uint16_t, 4> resolve_pixel(const FramePlan& plan, const Visibility& visible,
                                           const std::vector<std::vector<Vertex>>& vertices, int x, int y) {
  const std::span<const Sample> samples = visible.samples_of(x, y);
  const auto empty = static_cast<float>(part_of(samples, no_order).samples);
  const float all = static_cast<float>(samples.size());
  float sum[4] = {0, 0, 0, all - empty};
  if (plan.background) {
    const BackgroundRow& behind = (*plan.background)[static_cast<std::size_t>(y)];
    for (std::size_t c = 0; c < 4; ++c) sum[c] = std::fma(imath_half_to_float(behind[c]), empty, sum[c]);
  }
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (samples[s].order == no_order || !is_first(samples, s)) continue;
    const Part part = part_of(samples, samples[s].order);
    const glm::vec3 color = shade_part(plan, visible, samples[s], vertices, x, y, part.centroid());
    for (int c = 0; c < 3; ++c) sum[c] = std::fma(color[c], static_cast<float>(part.samples), sum[c]);
  }
  std::array<std::uint16_t, 4> pixel;
  for (std::size_t c = 0; c < 4; ++c) pixel[c] = imath_float_to_half(sum[c] * (1.0f / all));
  return pixel;
}

}  // namespace morphcl::reference
