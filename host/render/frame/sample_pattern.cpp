#include "host/render/frame/sample_pattern.hpp"

#include <array>

namespace morphcl {

namespace {

template <std::size_t count>
constexpr std::array<SampleOffset, count> pattern(const int (&x)[count], const int (&y)[count]) {
  std::array<SampleOffset, count> samples{};
  for (std::size_t i = 0; i < count; ++i) samples[i] = {x[i], y[i]};
  return samples;
}

constexpr auto samples_1 = pattern({SAMPLES_1_X}, {SAMPLES_1_Y});
constexpr auto samples_2 = pattern({SAMPLES_2_X}, {SAMPLES_2_Y});
constexpr auto samples_4 = pattern({SAMPLES_4_X}, {SAMPLES_4_Y});
constexpr auto samples_8 = pattern({SAMPLES_8_X}, {SAMPLES_8_Y});
constexpr auto samples_16 = pattern({SAMPLES_16_X}, {SAMPLES_16_Y});

template <std::size_t count>
constexpr bool reach_is_that_of_the_kernels(const std::array<SampleOffset, count>& samples) {
  int min_x = 8, max_x = -8, min_y = 8, max_y = -8;
  for (const SampleOffset& s : samples) {
    min_x = s.x < min_x ? s.x : min_x;
    max_x = s.x > max_x ? s.x : max_x;
    min_y = s.y < min_y ? s.y : min_y;
    max_y = s.y > max_y ? s.y : max_y;
  }
  constexpr int n = static_cast<int>(count);
  return min_x == MIN_SAMPLE(n) && min_y == MIN_SAMPLE(n) && max_x == MAX_SAMPLE(n) && max_y == MAX_SAMPLE(n);
}
static_assert(reach_is_that_of_the_kernels(samples_1) && reach_is_that_of_the_kernels(samples_2) &&
              reach_is_that_of_the_kernels(samples_4) && reach_is_that_of_the_kernels(samples_8) &&
              reach_is_that_of_the_kernels(samples_16));
static_assert(SUBPIXEL_BITS == 8 && SAMPLE_UNIT_BITS == 4, "samples lie on the grid of sub-pixels");

}  // namespace

std::span<const SampleOffset> sample_pattern(int samples) {
  switch (samples) {
    case 2:
      return samples_2;
    case 4:
      return samples_4;
    case 8:
      return samples_8;
    case 16:
      return samples_16;
    default:
      return samples_1;
  }
}

}  // namespace morphcl
