#include "anim/spring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

constexpr double pi = 0x1.921fb54442d18p+1;
constexpr double cascade_from = 1.15;  // damping ratio from which the two rates are far enough apart

// sum of (-z)^k / (2k + first)!, for |z| < 1/4: 9 terms are below 2^-60 of the sum.
double alternating_series(double z, int first) {
  constexpr int terms = 9;
  double sum = 1;
  for (int k = terms; k > 0; --k) {
    const int n = 2 * k + first;
    sum = std::fma(sum, -z / (n * (n - 1)), 1.0);
  }
  return sum;
}

// i! phi_{i+1}(-z) for i = 0..3: the mean of exp(-z s) weighted by (i+1)-fold integration; phi_1 = (1 - e^-z) / z.
std::array<double, 4> scaled_phi(double z) {
  constexpr double series_up_to = 2;
  std::array<double, 4> phi;
  if (z < series_up_to) {
    // i! phi_{i+1}(-z) = sum (-z)^n i! / (n + i + 1)!
    constexpr int terms = 26;
    for (int i = 0; i < 4; ++i) {
      double sum = 1;
      for (int n = terms; n > 0; --n) sum = std::fma(sum, -z / (n + i + 1), 1.0);
      phi[static_cast<std::size_t>(i)] = sum / (i + 1);
    }
  } else {
    phi[0] = -exponential_minus_1(-z) / z;
    for (std::size_t i = 1; i < 4; ++i) phi[i] = (1 - static_cast<double>(i) * phi[i - 1]) / z;
  }
  return phi;
}

}  // namespace

Spring spring_of_frequency(double frequency_hz, double damping_ratio) { return {2 * pi * frequency_hz, damping_ratio}; }

SpringStep::SpringStep(const Spring& spring, double seconds)
    : omega_squared_(spring.angular_frequency * spring.angular_frequency) {
  const double x = spring.angular_frequency * seconds, zeta = spring.damping_ratio;
  // The larger of the two rates times t, where there are two: the series serves while it is below 1.
  const double fast = zeta > cascade_from ? (zeta + std::sqrt((zeta - 1) * (zeta + 1))) * x : x;
  if (fast < 1)
    find_by_series(spring, seconds);
  else if (zeta > cascade_from)
    find_by_cascade(spring, seconds);
  else
    find_by_oscillation(spring, seconds);
}

// b_n = -(2 zeta x n b_{n-1} + x^2 b_{n-2}) / (n (n+1)), x = omega t.
void SpringStep::find_by_series(const Spring& spring, double t) {
  constexpr int terms = 26;
  const double x = spring.angular_frequency * t, damping = 2 * spring.damping_ratio * x, square = x * x;
  std::array<double, terms> b;
  b[0] = 1;
  b[1] = -0.5 * damping;
  for (int n = 2; n < terms; ++n) {
    const auto at = static_cast<std::size_t>(n);
    b[at] = -std::fma(damping * n, b[at - 1], square * b[at - 2]) / (static_cast<double>(n) * (n + 1));
  }
  double position = 0, velocity = 0;
  std::array<double, 4> response{};
  for (int n = terms - 1; n >= 0; --n) {
    double term = b[static_cast<std::size_t>(n)];
    position += term;
    velocity = std::fma(n + 1.0, term, velocity);
    for (int i = 0; i < 4; ++i) response[static_cast<std::size_t>(i)] += term /= n + 2 + i;
  }
  p12_ = t * position;
  p22_ = velocity;
  double scale = square;  // x^2 t^i i!
  for (std::size_t i = 0; i < 4; ++i) {
    response_[i] = scale * response[i];
    scale *= t * static_cast<double>(i + 1);
  }
  p11_ = 1 - response_[0];
}

void SpringStep::find_by_oscillation(const Spring& spring, double t) {
  const double omega = spring.angular_frequency, zeta = spring.damping_ratio, a = zeta * omega;
  const double q = (1 - zeta) * (1 + zeta);  // (d / omega)^2
  const double z = q * (omega * t) * (omega * t);
  const double d = omega * std::sqrt(std::abs(q));
  double sine, cosine;  // e^-at sin(dt) / d and e^-at cos(dt), hyperbolic where q < 0
  if (std::abs(z) < 0.25) {
    const double decay = exponential(-a * t);
    sine = decay * t * alternating_series(z, 1);
    cosine = decay * alternating_series(z, 0);
  } else if (q > 0) {
    const double decay = exponential(-a * t);
    sine = decay * morphcl::sine(d * t) / d;
    cosine = decay * morphcl::cosine(d * t);
  } else {
    const double decay = exponential(-omega * omega / (a + d) * t), difference = exponential_minus_1(-2 * d * t);
    sine = decay * -difference / (2 * d);
    cosine = decay * (1 + 0.5 * difference);
  }
  p12_ = sine;
  p11_ = std::fma(a, sine, cosine);
  p22_ = std::fma(-a, sine, cosine);
  // r_i solves the equation itself, r_i' = i r_{i-1}: r_i = t^i - (2 zeta/omega) i r_{i-1} - i (i-1)/omega^2 r_{i-2}.
  const double lag = 2 * zeta / omega;
  response_[0] = 1 - p11_;
  response_[1] = t - lag * response_[0] - p12_;
  response_[2] = t * t - 2 * lag * response_[1] - 2 / omega_squared_ * response_[0];
  response_[3] = t * t * t - 3 * lag * response_[2] - 6 / omega_squared_ * response_[1];
}

void SpringStep::find_by_cascade(const Spring& spring, double t) {
  const double omega = spring.angular_frequency, zeta = spring.damping_ratio;
  const double d = omega * std::sqrt((zeta - 1) * (zeta + 1));
  const double fast = zeta * omega + d, slow = omega_squared_ / fast;
  const double fast_decay = exponential(-fast * t), slow_decay = exponential(-slow * t);
  p12_ = slow_decay * -exponential_minus_1(-2 * d * t) / (2 * d);
  p11_ = (fast * slow_decay - slow * fast_decay) / (2 * d);
  p22_ = (fast * fast_decay - slow * slow_decay) / (2 * d);
  const std::array<double, 4> slow_phi = scaled_phi(slow * t), fast_phi = scaled_phi(fast * t);
  double scale = slow * t * (fast / (2 * d));  // omega^2 t / (2d) t^i
  for (std::size_t i = 0; i < 4; ++i) {
    response_[i] = scale * (slow_phi[i] - fast_phi[i]);
    scale *= t;
  }
}

SpringState SpringStep::apply(const SpringState& from, const Cubic& g) const {
  const double pull = g[0] - from.position;
  // Measured from where the mass is nearer to: from its place while it has hardly moved, from the target's once it
  // came.
  const double moved = response_[0] < 0.5 ? std::fma(response_[0], pull, from.position) : std::fma(-p11_, pull, g[0]);
  const double followed = std::fma(g[1], response_[1], std::fma(g[2], response_[2], g[3] * response_[3]));
  const double follow_speed = std::fma(g[1], response_[0], std::fma(2 * g[2], response_[1], 3 * g[3] * response_[2]));
  return {std::fma(p12_, from.velocity, moved + followed),
          std::fma(p22_, from.velocity, std::fma(omega_squared_ * p12_, pull, follow_speed))};
}

double settling_seconds(const Spring& spring) {
  constexpr double log_of_1000 = 0x1.ba18a998fffap+2, max_seconds = 10;
  const double zeta = spring.damping_ratio;
  const double slowest = zeta <= 1 ? zeta : 1 / (zeta + std::sqrt((zeta - 1) * (zeta + 1)));
  const double rate = slowest * spring.angular_frequency;
  return rate * max_seconds > log_of_1000 ? log_of_1000 / rate : max_seconds;
}

double largest_overshoot(double zeta) {
  if (zeta >= 1) return 1;
  if (zeta <= 0) return std::numeric_limits<double>::infinity();
  const double half_turn = -pi * zeta / std::sqrt((1 - zeta) * (1 + zeta));
  return (1 + exponential(half_turn)) / -exponential_minus_1(half_turn);
}

}  // namespace morphcl
