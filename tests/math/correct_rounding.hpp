// What the correctly rounded functions of host/math are judged by: MPFR, whose results are correctly rounded for any
// precision.
#pragma once

#include <string>
#include <vector>

namespace morphcl::reference {

// A function of host/math under test and its counterpart in MPFR.
struct RoundedFunction {
  std::string name;
  double (*computed)(double x);
  double (*exact)(double x);        // to nearest, subnormals included
  double (*bits_to_tie)(double x);  // -log2 of the distance to the middle of two doubles, in ulp; capped at 200
};

// sine, cosine, tangent, exponential, exponential_minus_1, sine and cosine of degrees, and the arc tangents of x / 1,
// 1 / x and x / -3.
const std::vector<RoundedFunction>& rounded_functions();
const RoundedFunction& rounded_function(const std::string& name);

double exact_arc_tangent(double y, double x);

// The double nearest to k pi / 2.
double near_quarter_turns(unsigned long k);

}  // namespace morphcl::reference
