// One step of x'' + c x' + k (x - g(t)) = 0 by the integrators of the textbooks, for a target g that is linear within
// the step: what springs are usually simulated by.
//
// Each has prepare(c, k, h), and step(state, g0, g1) from g0 at the step's start to g1 at its end. Multistep methods
// start anew after restart().
#pragma once

namespace morphcl::accuracy {

struct Motion {
  double x = 0, v = 0;
};

class Oscillator {
 public:
  void prepare(double damping, double stiffness, double step) {
    c_ = damping;
    k_ = stiffness;
    h_ = step;
  }
  void restart() {}

 protected:
  double force(const Motion& m, double g) const { return -c_ * m.v - k_ * (m.x - g); }

  // The solution of y = known + s f(y), by elimination; `s` is a fraction of the step in seconds.
  Motion solve(const Motion& known, double s, double g) const {
    const double v = (known.v - s * k_ * (known.x - g)) / (1 + s * c_ + s * s * k_);
    return {known.x + s * v, v};
  }

  double c_ = 0, k_ = 0, h_ = 0;
};

struct ExplicitEuler : Oscillator {
  void step(Motion& m, double g0, double) const { m = {m.x + h_ * m.v, m.v + h_ * force(m, g0)}; }
};

struct SymplecticEuler : Oscillator {
  void step(Motion& m, double g0, double) const {
    m.v += h_ * force(m, g0);
    m.x += h_ * m.v;
  }
};

struct RungeKutta4 : Oscillator {
  void step(Motion& m, double g0, double g1) const {
    const double middle = 0.5 * (g0 + g1), half = 0.5 * h_;
    const Motion k1{m.v, force(m, g0)}, at2{m.x + half * k1.x, m.v + half * k1.v};
    const Motion k2{at2.v, force(at2, middle)}, at3{m.x + half * k2.x, m.v + half * k2.v};
    const Motion k3{at3.v, force(at3, middle)}, at4{m.x + h_ * k3.x, m.v + h_ * k3.v};
    const Motion k4{at4.v, force(at4, g1)};
    m.x += h_ / 6 * (k1.x + 2 * k2.x + 2 * k3.x + k4.x);
    m.v += h_ / 6 * (k1.v + 2 * k2.v + 2 * k3.v + k4.v);
  }
};

struct ImplicitEuler : Oscillator {
  void step(Motion& m, double, double g1) const { m = solve(m, h_, g1); }
};

struct Trapezoidal : Oscillator {
  void step(Motion& m, double g0, double g1) const {
    const double half = 0.5 * h_;
    m = solve({m.x + half * m.v, m.v + half * force(m, g0)}, half, g1);
  }
};

// y1 = (4 y0 - y_before) / 3 + 2/3 h f(y1); the first step by the implicit Euler method.
struct Bdf2 : Oscillator {
  void restart() { started_ = false; }
  void step(Motion& m, double, double g1) {
    const Motion now = m;
    m = started_ ? solve({(4 * m.x - before_.x) / 3, (4 * m.v - before_.v) / 3}, 2 * h_ / 3, g1) : solve(m, h_, g1);
    before_ = now;
    started_ = true;
  }

 private:
  Motion before_;
  bool started_ = false;
};

// The trapezoidal rule to t + gamma h, gamma = 2 - sqrt 2, then BDF2 over both parts (Bank et al. 1985).
struct TrBdf2 : Oscillator {
  void step(Motion& m, double g0, double g1) const {
    constexpr double gamma = 0.58578643762690495, part = 0.5 * gamma;
    const double s = part * h_, g_middle = g0 + gamma * (g1 - g0);
    const Motion middle = solve({m.x + s * m.v, m.v + s * force(m, g0)}, s, g_middle);
    constexpr double a = 1 / (gamma * (2 - gamma)), b = (1 - gamma) * (1 - gamma) * a;
    m = solve({a * middle.x - b * m.x, a * middle.v - b * m.v}, (1 - gamma) / (2 - gamma) * h_, g1);
  }
};

// Two stages on one diagonal entry, gamma = 1 - 1 / sqrt 2 (Alexander 1977).
struct Sdirk2 : Oscillator {
  void step(Motion& m, double g0, double g1) const {
    constexpr double gamma = 0.29289321881345248;
    const double s = gamma * h_, g_first = g0 + gamma * (g1 - g0);
    const Motion first = solve(m, s, g_first);
    const Motion slope{first.v, force(first, g_first)};
    m = solve({m.x + (1 - gamma) * h_ * slope.x, m.v + (1 - gamma) * h_ * slope.v}, s, g1);
  }
};

}  // namespace morphcl::accuracy
