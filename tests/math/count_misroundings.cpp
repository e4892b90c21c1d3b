// How often a correctly rounded function of host/math misses the double that MPFR names: as many arguments as one has
// the time for.
//
// Usage: morphcl_count_misroundings FUNCTION ARGUMENTS [SEED]. Prints the number of arguments, of misses, and the
// hardest argument (the one whose value lies closest to the middle of two doubles). Exit code 1 if there is a miss.
//
// MPFR is asked only where it must be: a value in a wider format that is clearly nearer to one double than to any other
// names that double. On x86 this is the 64-bit long double, whose library functions err by a few units of 2^-64: what
// is within 2^-6 ulp of a middle goes to MPFR.
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "tests/math/elementary_arguments.hpp"

namespace {

using morphcl::reference::RoundedFunction;
using WideFunction = long double (*)(long double);

// None of the wider functions knows degrees.
const std::map<std::string, WideFunction> wide_functions = {
    {"sine", [](long double x) { return std::sin(x); }},
    {"cosine", [](long double x) { return std::cos(x); }},
    {"tangent", [](long double x) { return std::tan(x); }},
    {"exponential", [](long double x) { return std::exp(x); }},
    {"exponential_minus_1", [](long double x) { return std::expm1(x); }},
    {"arc_tangent_over_1", [](long double x) { return std::atan(x); }},
    {"arc_tangent_under_1", [](long double x) { return std::atan2(1.0L, x); }},
    {"arc_tangent_over_minus_3", [](long double x) { return std::atan2(x, -3.0L); }},
};

// The double nearest to every value within 2^-6 ulp of `wide`, if there is one.
std::optional<double> clearly_nearest(long double wide) {
  const auto nearest = static_cast<double>(wide);
  if (!(std::abs(nearest) > 0x1p-1000 && std::abs(nearest) < 0x1p1000)) return std::nullopt;
  const long double margin = std::abs(wide) * 0x1p-59L;
  if (static_cast<double>(wide - margin) != nearest || static_cast<double>(wide + margin) != nearest)
    return std::nullopt;
  return nearest;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count < 3) {
    fmt::print(stderr, "usage: {} FUNCTION ARGUMENTS [SEED]\n", arguments[0]);
    return 2;
  }
  const std::string name = arguments[1];
  const RoundedFunction& function = morphcl::reference::rounded_function(name);
  const auto count = std::strtoull(arguments[2], nullptr, 10);
  morphcl::reference::ElementaryArguments next(argument_count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 1);
  constexpr bool is_wider = std::numeric_limits<long double>::digits >= 64;
  const auto wide = wide_functions.find(function.name);

  unsigned long long misses = 0, asked = 0;
  double hardest = 0, hardest_bits = 0;
  for (unsigned long long i = 0; i < count; ++i) {
    const double x = next.next(), computed = function.computed(x);
    if (is_wider && wide != wide_functions.end()) {
      const std::optional<double> clear = clearly_nearest(wide->second(x));
      if (clear && *clear == computed) continue;
    }
    ++asked;
    const double exact = function.exact(x);
    if (!same(exact, computed)) {
      ++misses;
      fmt::print("{}({:a}) = {:a}, computed {:a}\n", function.name, x, exact, computed);
    }
    if (const double bits = function.bits_to_tie(x); bits < 200 && bits > hardest_bits) {
      hardest = x;
      hardest_bits = bits;
    }
  }
  fmt::print("{}: {} arguments, {} misses; {} decided by MPFR; hardest {:a}: 2^-{} ulp from a middle\n", function.name,
             count, misses, asked, hardest, hardest_bits);
  return misses == 0 ? 0 : 1;
}
