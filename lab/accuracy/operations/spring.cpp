// A spring that follows keys: the product's closed form, and integrators with so many substeps a frame.
#include "anim/spring.hpp"

#include <array>
#include <cmath>
#include <complex>

#include "lab/accuracy/operations/integrators.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "lab/accuracy/planar_operation.hpp"

namespace morphcl::accuracy {

namespace {

constexpr int spring_frames = 48;
constexpr double spring_frame_seconds = 1.0 / 24;

// The target's value at frame k of a spring whose keys begin at `phase`: multiples of 1/8, from 0 to 10/8.
double spring_target(double phase, int k) {
  const auto n = static_cast<long>(phase) + k;
  return static_cast<double>((7 * n * n + 3 * n) % 11) / 8;
}

// Planes: the phase. Constants: angular frequency and damping ratio. Results: positions at frames 1 to 48. `follow`
// makes a function (state, g0, g1) that goes on by a frame.
template <class Follow>
Variant<double> following_target(const std::string& name, Follow follow) {
  return {.name = name, .prepare = [follow](const Batch& batch) -> Variant<double>::Run {
            const auto prepared = follow(batch.constants[0], batch.constants[1]);
            return [prepared, phases = batch.truth.plane(0), count = batch.size()](Planes<double>& results) {
              for (std::size_t i = 0; i < count; ++i) {
                auto advance = prepared;
                Motion motion;
                for (int k = 0; k < spring_frames; ++k) {
                  advance(motion, spring_target(phases[i], k), spring_target(phases[i], k + 1));
                  results.plane(static_cast<std::size_t>(k))[i] = motion.x;
                }
              }
            };
          }};
}

template <class Integrator>
Variant<double> integrated_spring(const char* name, int substeps) {
  return following_target(std::string(name) + ", " + std::to_string(substeps), [substeps](double omega, double zeta) {
    Integrator integrator;
    integrator.prepare(2 * zeta * omega, omega * omega, spring_frame_seconds / substeps);
    return [integrator, substeps](Motion& motion, double g0, double g1) mutable {
      // The target has a kink at each frame.
      integrator.restart();
      for (int j = 0; j < substeps; ++j)
        integrator.step(motion, g0 + (g1 - g0) * j / substeps, g0 + (g1 - g0) * (j + 1) / substeps);
    };
  });
}

// x = x_p + A e^(r1 t) + B e^(r2 t), with the roots r of r^2 + 2 zeta omega r + omega^2: near critical damping A and B
// grow without limit and cancel.
Variant<double> two_exponentials() {
  Variant<double> variant = following_target("two exponentials", [](double omega, double zeta) {
    using Complex = std::complex<double>;
    const double a = zeta * omega;
    const Complex root = std::sqrt(Complex(a * a - omega * omega)), r1 = -a + root, r2 = -a - root;
    const Complex e1 = std::exp(r1 * spring_frame_seconds), e2 = std::exp(r2 * spring_frame_seconds);
    return [=](Motion& motion, double g0, double g1) {
      const double slope = (g1 - g0) / spring_frame_seconds, lag = 2 * zeta * slope / omega;
      const Complex e = motion.x - (g0 - lag), v = motion.v - slope;
      const Complex first = (v - r2 * e) / (r1 - r2), second = e - first;
      motion.x = g1 - lag + (first * e1 + second * e2).real();
      motion.v = slope + (first * r1 * e1 + second * r2 * e2).real();
    };
  });
  variant.c_library = true;
  return variant;
}

Variant<double> closed_form() {
  Variant<double> variant = following_target("closed form", [](double omega, double zeta) {
    return [step = SpringStep(Spring{omega, zeta}, spring_frame_seconds)](Motion& motion, double g0, double g1) {
      const SpringState next = step.apply({motion.x, motion.v}, Cubic{g0, (g1 - g0) / spring_frame_seconds, 0, 0});
      motion = {next.position, next.velocity};
    };
  });
  variant.ships = true;
  return variant;
}

std::vector<Variant<double>> spring_variants(bool quick) {
  std::vector<Variant<double>> all = {
      integrated_spring<ExplicitEuler>("explicit Euler", 64),
      integrated_spring<ExplicitEuler>("explicit Euler", 1024),
      integrated_spring<SymplecticEuler>("symplectic Euler", 64),
      integrated_spring<RungeKutta4>("RK4", 16),
      integrated_spring<ImplicitEuler>("implicit Euler", 4),
      integrated_spring<ImplicitEuler>("implicit Euler", 64),
      integrated_spring<Trapezoidal>("trapezoidal", 4),
      integrated_spring<Trapezoidal>("trapezoidal", 64),
      integrated_spring<Bdf2>("BDF2", 4),
      integrated_spring<Bdf2>("BDF2", 64),
      integrated_spring<TrBdf2>("TR-BDF2", 4),
      integrated_spring<TrBdf2>("TR-BDF2", 64),
      integrated_spring<Sdirk2>("SDIRK2", 4),
      integrated_spring<Sdirk2>("SDIRK2", 64),
      two_exponentials(),
      closed_form(),
  };
  if (!quick) all.insert(all.begin() + 2, integrated_spring<ExplicitEuler>("explicit Euler", 65536));
  return all;
}

InputFamily spring_family(const char* name, const char* text, double omega, double zeta) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 1, count, {omega, zeta},
                         [](Random& r, double* in) { in[0] = r.integer(0, 1'000'000); });
          }};
}

// The state after a frame from unit displacement (11, 21) and unit velocity (12, 22), in as many digits as Number has.
template <class Number>
struct ExactStep {
  Number p11, p12, p21, p22;

  ExactStep(const Number& omega, const Number& zeta) {
    const Number a = zeta * omega, q = omega * omega * (1 - zeta) * (1 + zeta), t = Number(1) / 24, decay = exp(-a * t);
    const Number d = sqrt(abs(q));
    const Number c = q > 0 ? Number(cos(d * t)) : Number(cosh(d * t));
    const Number s = q > 0 ? Number(sin(d * t) / d) : Number(sinh(d * t) / d);
    p12 = decay * s;
    p11 = decay * (c + a * s);
    p21 = -omega * omega * p12;
    p22 = decay * (c - a * s);
  }
};

OperationReport run_spring(const Settings& settings, const Description& about) {
  PlanarOperation<double> op;
  op.about = about;
  op.results = spring_frames;
  op.families = {
      spring_family("benign", "10 radians a second, damping ratio 0.2", 10, 0.2),
      spring_family("wide", "stiff: 10^6 radians a second, damping ratio 0.5", 1e6, 0.5),
      spring_family("adversarial", "critical but for 10^-12: 50 radians a second, damping ratio 1 + 10^-12", 50,
                    1 + 1e-12),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const Number omega = in.constant(0), zeta = in.constant(1);
    const ExactStep<Number> step(omega, zeta);
    Number x = 0, v = 0;
    for (int k = 0; k < spring_frames; ++k) {
      const Number g0 = spring_target(in(0, i), k), g1 = spring_target(in(0, i), k + 1), slope = (g1 - g0) * 24;
      const Number lag = 2 * zeta * slope / omega, e = x - (g0 - lag), w = v - slope;
      x = g1 - lag + step.p11 * e + step.p12 * w;
      v = slope + step.p21 * e + step.p22 * w;
      results[k] = {x, Number(1)};
    }
  });
  op.variants = spring_variants(settings.quick);
  op.compared = 32;
  op.batch = 2;
  op.steps_per_element = spring_frames;
  return run_planar(op, settings);
}

}  // namespace

Operation spring() {
  const Description about = {.name = "spring",
                             .title =
                                 "a spring that follows keys at 24 frames a second; substeps a frame; times are for "
                                 "a frame",
                             .results = "the track's unit",
                             .format = binary64,
                             .plotted = Measure::max_absolute,
                             .target = 1e-4,
                             .reason = "a tenth of a pixel where 1 is 1000 pixels"};
  return {about, [about](const Settings& settings) { return run_spring(settings, about); }};
}

}  // namespace morphcl::accuracy
