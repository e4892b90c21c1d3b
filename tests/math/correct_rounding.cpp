#include "tests/math/correct_rounding.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "morphcl/numerics.hpp"

namespace morphcl::reference {

namespace {

using Evaluate = int (*)(mpfr_t result, const mpfr_t x);

class Number {
 public:
  explicit Number(mpfr_prec_t precision) { mpfr_init2(value, precision); }
  ~Number() { mpfr_clear(value); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  mpfr_t value;
};

// The exponents of doubles, so that MPFR overflows and underflows where they do.
void use_exponents_of_doubles() {
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
}

double to_nearest(mpfr_t result, int ternary) {
  mpfr_subnormalize(result, ternary, MPFR_RNDN);
  return mpfr_get_d(result, MPFR_RNDN);
}

template <Evaluate evaluate>
double exact(double x) {
  use_exponents_of_doubles();
  thread_local Number argument(53), result(53);
  mpfr_set_d(argument.value, x, MPFR_RNDN);
  return to_nearest(result.value, evaluate(result.value, argument.value));
}

template <Evaluate evaluate>
double bits_to_tie(double x) {
  use_exponents_of_doubles();
  thread_local Number argument(53), result(400), half_ulps(400), rest(400);
  mpfr_set_d(argument.value, x, MPFR_RNDN);
  evaluate(result.value, argument.value);
  if (!mpfr_regular_p(result.value)) return 0;
  // In half ulps; ties are the odd integers.
  mpfr_mul_2si(half_ulps.value, result.value, 54 - mpfr_get_exp(result.value), MPFR_RNDN);
  mpfr_sub_ui(half_ulps.value, half_ulps.value, 1, MPFR_RNDN);
  mpfr_div_2ui(half_ulps.value, half_ulps.value, 1, MPFR_RNDN);
  mpfr_rint(rest.value, half_ulps.value, MPFR_RNDN);
  mpfr_sub(rest.value, half_ulps.value, rest.value, MPFR_RNDN);
  return mpfr_zero_p(rest.value) ? 200 : std::min(200.0, static_cast<double>(-mpfr_get_exp(rest.value)));
}

int sine_degrees(mpfr_t result, const mpfr_t x) { return mpfr_sinu(result, x, 360, MPFR_RNDN); }
int cosine_degrees(mpfr_t result, const mpfr_t x) { return mpfr_cosu(result, x, 360, MPFR_RNDN); }
int sine_radians(mpfr_t result, const mpfr_t x) { return mpfr_sin(result, x, MPFR_RNDN); }
int cosine_radians(mpfr_t result, const mpfr_t x) { return mpfr_cos(result, x, MPFR_RNDN); }
int tangent_radians(mpfr_t result, const mpfr_t x) { return mpfr_tan(result, x, MPFR_RNDN); }
int exponential_of(mpfr_t result, const mpfr_t x) { return mpfr_exp(result, x, MPFR_RNDN); }
int exponential_minus_1_of(mpfr_t result, const mpfr_t x) { return mpfr_expm1(result, x, MPFR_RNDN); }
int arc_tangent_over_1(mpfr_t result, const mpfr_t x) { return mpfr_atan(result, x, MPFR_RNDN); }
int arc_tangent_under_1(mpfr_t result, const mpfr_t x) {
  Number one(2);
  mpfr_set_ui(one.value, 1, MPFR_RNDN);
  return mpfr_atan2(result, one.value, x, MPFR_RNDN);
}
int arc_tangent_over_minus_3(mpfr_t result, const mpfr_t x) {
  Number minus_3(2);
  mpfr_set_si(minus_3.value, -3, MPFR_RNDN);
  return mpfr_atan2(result, x, minus_3.value, MPFR_RNDN);
}

template <Evaluate evaluate>
RoundedFunction function(const char* name, double (*computed)(double)) {
  return {name, computed, exact<evaluate>, bits_to_tie<evaluate>};
}

}  // namespace

const std::vector<RoundedFunction>& rounded_functions() {
  static const std::vector<RoundedFunction> functions = {
      function<sine_radians>("sine", sine),
      function<cosine_radians>("cosine", cosine),
      function<tangent_radians>("tangent", tangent),
      function<exponential_of>("exponential", exponential),
      function<exponential_minus_1_of>("exponential_minus_1", exponential_minus_1),
      function<sine_degrees>("sine_degrees", [](double x) { return sin_cos_degrees(x).sin; }),
      function<cosine_degrees>("cosine_degrees", [](double x) { return sin_cos_degrees(x).cos; }),
      function<arc_tangent_over_1>("arc_tangent_over_1", [](double x) { return arc_tangent(x, 1); }),
      function<arc_tangent_under_1>("arc_tangent_under_1", [](double x) { return arc_tangent(1, x); }),
      function<arc_tangent_over_minus_3>("arc_tangent_over_minus_3", [](double x) { return arc_tangent(x, -3); }),
  };
  return functions;
}

const RoundedFunction& rounded_function(const std::string& name) {
  for (const RoundedFunction& function : rounded_functions())
    if (function.name == name) return function;
  throw std::invalid_argument("no function " + name);
}

double exact_arc_tangent(double y, double x) {
  use_exponents_of_doubles();
  thread_local Number ordinate(53), abscissa(53), result(53);
  mpfr_set_d(ordinate.value, y, MPFR_RNDN);
  mpfr_set_d(abscissa.value, x, MPFR_RNDN);
  return to_nearest(result.value, mpfr_atan2(result.value, ordinate.value, abscissa.value, MPFR_RNDN));
}

double near_quarter_turns(unsigned long k) {
  use_exponents_of_doubles();
  Number turns(200);
  mpfr_const_pi(turns.value, MPFR_RNDN);
  mpfr_mul_ui(turns.value, turns.value, k, MPFR_RNDN);
  return 0.5 * mpfr_get_d(turns.value, MPFR_RNDN);
}

}  // namespace morphcl::reference
