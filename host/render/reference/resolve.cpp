#include "host/render/reference/resolve.hpp"

#include <Imath/half.h>

#include <cmath>

#include "host/render/frame/sample_pattern.hpp"

namespace morphcl::reference {

namespace {

// What a sample shows in front of its opaque surface.
struct BlendedLayers {
  glm::vec3 color{0};       // premultiplied
  float transmittance = 1;  // of what lies behind
};

BlendedLayers blend(const FramePlan& plan, const Visibility& visible, const std::vector<std::vector<Vertex>>& vertices,
                    int x, int y, std::span<const Layer> front_to_back) {
  BlendedLayers sum;
  for (const Layer& layer : front_to_back) {
    const auto [color, alpha] = shade_layer(plan, visible, layer.surface, vertices, x, y);
    const float share = sum.transmittance * alpha;
    for (int c = 0; c < 3; ++c) sum.color[c] = std::fma(share, color[c], sum.color[c]);
    sum.transmittance = std::fma(-sum.transmittance, alpha, sum.transmittance);
  }
  return sum;
}

bool is_first(std::span<const Sample> samples, std::size_t s) {
  for (std::size_t before = 0; before < s; ++before)
    if (samples[before].order == samples[s].order) return false;
  return true;
}

}  // namespace

ShadedSurface shade_layer(const FramePlan& plan, const Visibility& visible, const Sample& layer,
                          const std::vector<std::vector<Vertex>>& vertices, int x, int y) {
  return visible.samples_a_pixel == 1 ? shade_centre(plan, visible, layer, vertices, x, y)
                                      : shade_part(plan, visible, layer, vertices, x, y, std::nullopt);
}

std::array<std::uint16_t, 4> resolve_pixel(const FramePlan& plan, const Visibility& visible,
                                           const std::vector<std::vector<Vertex>>& vertices, int x, int y) {
  const std::span<const Sample> samples = visible.samples_of(x, y);
  const std::span<const SampleOffset> pattern = sample_pattern(visible.samples_a_pixel);
  std::array<BlendedLayers, 16> in_front;
  float empty = 0, through_empty = 0;  // samples without an opaque surface, and what layers let through there
  float alpha_of_empty = 0;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (plan.blends) in_front[s] = blend(plan, visible, vertices, x, y, visible.layers_of(visible.index(x, y) + s));
    if (samples[s].order != no_order) continue;
    empty += 1;
    through_empty += in_front[s].transmittance;
    alpha_of_empty += 1 - in_front[s].transmittance;
  }
  const auto all = static_cast<float>(samples.size());
  float sum[4] = {0, 0, 0, all - empty};
  if (plan.background) {
    const BackgroundRow& behind = (*plan.background)[static_cast<std::size_t>(y)];
    for (std::size_t c = 0; c < 3; ++c) sum[c] = imath_half_to_float(behind[c]) * through_empty;
    sum[3] = std::fma(imath_half_to_float(behind[3]), empty, sum[3]);
  } else {
    sum[3] += alpha_of_empty;
  }
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (samples[s].order == no_order || !is_first(samples, s)) continue;
    PixelPart part;
    float through = 0;
    for (std::size_t other = s; other < samples.size(); ++other)
      if (samples[other].order == samples[s].order) {
        part.add(pattern[other]);
        through += in_front[other].transmittance;
      }
    const glm::vec3 color =
        samples.size() == 1
            ? shade_centre(plan, visible, samples[s], vertices, x, y).color
            : shade_part(plan, visible, samples[s], vertices, x, y, part.centroid(visible.samples_a_pixel)).color;
    for (int c = 0; c < 3; ++c) sum[c] = std::fma(color[c], through, sum[c]);
  }
  for (std::size_t s = 0; s < samples.size() && plan.blends; ++s)
    for (int c = 0; c < 3; ++c) sum[c] += in_front[s].color[c];
  std::array<std::uint16_t, 4> pixel;
  for (std::size_t c = 0; c < 4; ++c) pixel[c] = imath_float_to_half(sum[c] * (1.0f / all));
  return pixel;
}

namespace {

const Sample& shown_surface(const FramePlan& plan, const Visibility& visible,
                            const std::vector<std::vector<Vertex>>& vertices, int x, int y, std::size_t sample) {
  const std::size_t index = visible.index(x, y) + sample;
  if (plan.blends)
    for (const Layer& layer : visible.layers_of(index))
      if (shade_layer(plan, visible, layer.surface, vertices, x, y).alpha >= 0.5f) return layer.surface;
  return visible.samples[index];
}

}  // namespace

const Sample& surface_at_centre(const FramePlan& plan, const Visibility& visible,
                                const std::vector<std::vector<Vertex>>& vertices, int x, int y) {
  return shown_surface(plan, visible, vertices, x, y, 0);
}

ShownSurfaces shown_surfaces(const FramePlan& plan, const Visibility& visible,
                             const std::vector<std::vector<Vertex>>& vertices, int x, int y) {
  ShownSurfaces shown;
  float opaque = 0, through_layers = 0;
  const std::span<const Sample> samples = visible.samples_of(x, y);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    shown.of_samples.push_back(shown_surface(plan, visible, vertices, x, y, s));
    if (samples[s].order != no_order)
      opaque += 1;
    else
      through_layers +=
          1 - blend(plan, visible, vertices, x, y, visible.layers_of(visible.index(x, y) + s)).transmittance;
  }
  shown.coverage = (opaque + through_layers) * (1.0f / static_cast<float>(samples.size()));
  return shown;
}

}  // namespace morphcl::reference
