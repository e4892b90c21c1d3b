// An object that symbols_test.cpp must find: it calls a function of the C library that is not correctly rounded.
#include <cmath>

namespace morphcl::architecture {

double forbidden_call(double x, double y) { return std::sqrt(std::hypot(x, y)); }

}  // namespace morphcl::architecture
