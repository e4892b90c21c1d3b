#include "morphcl/numerics.hpp"

#include <cmath>
#include <limits>

#include "host/math/accurate_sine.hpp"
#include "host/math/circle_constants.hpp"
#include "host/math/double_double.hpp"
#include "host/math/quarter_turns.hpp"
#include "host/math/sine_kernel.hpp"

namespace morphcl {

namespace {

// Below this the sine and tangent of x are x, and the cosine is 1, within less than half an ulp: x^2/3 < 2^-55.
constexpr double tiny_angle = 0x1p-27;
constexpr double quarter_pi = 0x1.921fb54442d18p-1;  // below pi/4

constexpr double sine_error = 2 * sine_kernel_error;  // with the reduction's and the rounding test's own roundings
constexpr double tangent_error = 4 * sine_kernel_error;

// |x| = (quarters + or - the rest) * pi/2; r is the rest in radians.
struct Angle {
  QuarterTurns turns;
  DoubleDouble r;
};

MORPHCL_INLINED Angle reduced(double size) {
  Angle angle;
  if (size <= quarter_pi) {
    angle.r = {size, 0};
  } else {
    angle.turns = quarter_turns(size);
    angle.r = to_double_double(angle.turns.rest) * half_pi_double_double;
  }
  return angle;
}

Float256 accurate_rest(double size, const QuarterTurns& turns) {
  return size <= quarter_pi ? to_float_256(size) : to_float_256(turns.rest * half_pi_fixed);
}

// The function is +-sin r or +-cos r, as the quarter and the side of the rest decide.
struct Form {
  bool is_cosine, negative;
};

Form form_of(unsigned quarter_of_sine, bool below) {
  const bool is_cosine = quarter_of_sine % 2 != 0;
  // sin(-r) = -sin r, cos(-r) = cos r.
  return {is_cosine, (quarter_of_sine % 4 >= 2) != (below && !is_cosine)};
}

MORPHCL_INLINED double sine_from_quarter(double size, unsigned first_quarter) {
  const Angle angle = reduced(size);
  const Form form = form_of(angle.turns.quarters + first_quarter, angle.turns.below);
  const DoubleDouble value = form.is_cosine ? cosine_kernel(angle.r) : sine_kernel(angle.r);
  double result = 0;
  if (const auto fast = rounded(value, sine_error)) {
    result = *fast;
  } else {
    const Float256 r = accurate_rest(size, angle.turns);
    result = to_double(form.is_cosine ? to_float_256(accurate_cosine(r)) : accurate_sine(r));
  }
  return form.negative ? -result : result;
}

}  // namespace

MORPHCL_WITH_HARDWARE_FMA double sine(double x) {
  const double size = std::abs(x);
  if (!(size <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::quiet_NaN();
  if (size < tiny_angle) return x;
  const double result = sine_from_quarter(size, 0);
  return x < 0 ? -result : result;
}

MORPHCL_WITH_HARDWARE_FMA double cosine(double x) {
  const double size = std::abs(x);
  if (!(size <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::quiet_NaN();
  if (size < tiny_angle) return 1;
  return sine_from_quarter(size, 1);
}

MORPHCL_WITH_HARDWARE_FMA double tangent(double x) {
  const double size = std::abs(x);
  if (!(size <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::quiet_NaN();
  if (size < tiny_angle) return x;
  const Angle angle = reduced(size);
  // tan r in even quarters, -cot r in odd ones; both are odd in r.
  const bool cotangent = angle.turns.quarters % 2 != 0;
  const bool negative = (cotangent != angle.turns.below) != (x < 0);
  const DoubleDouble sin = sine_kernel(angle.r), cos = cosine_kernel(angle.r);
  double result = 0;
  if (const auto fast = rounded(cotangent ? cos / sin : sin / cos, tangent_error)) {
    result = *fast;
  } else {
    const Float256 r = accurate_rest(size, angle.turns);
    const Float256 exact_sin = accurate_sine(r), exact_cos = to_float_256(accurate_cosine(r));
    result = to_double(cotangent ? exact_cos / exact_sin : exact_sin / exact_cos);
  }
  return negative ? -result : result;
}

}  // namespace morphcl
