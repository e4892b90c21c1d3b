// Coupled springs of very unequal stiffness: the product's modal form and TR-BDF2 beside the usual integrators.
#include <cmath>
#include <memory>

#include "anim/spring.hpp"
#include "anim/tr_bdf2.hpp"
#include "anim/vibration_modes.hpp"
#include "lab/accuracy/operations/chain_integrators.hpp"
#include "lab/accuracy/operations/exact_chain.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "lab/accuracy/planar_operation.hpp"

namespace morphcl::accuracy {

namespace {

constexpr int chain_frames = 24;
constexpr double chain_frame_seconds = 1.0 / 24;

ChainVector targets(double phase, int frame) {
  ChainVector g;
  for (std::size_t i = 0; i < chain_masses; ++i) g[i] = chain_target(phase, frame, i);
  return g;
}

// Planes: the phase. Results: the masses' positions after the last frame. `make` makes a function (positions, g0, g1)
// that goes on by a frame from rest.
template <class Make>
Variant<double> following_chain(const std::string& name, Make make) {
  return {.name = name, .prepare = [make](const Batch& batch) -> Variant<double>::Run {
            const auto prepared = make();
            return [prepared, phases = batch.truth.plane(0), count = batch.size()](Planes<double>& results) {
              for (std::size_t i = 0; i < count; ++i) {
                auto advance = prepared;
                ChainVector positions{};
                for (int k = 0; k < chain_frames; ++k)
                  advance(positions, targets(phases[i], k), targets(phases[i], k + 1));
                for (std::size_t m = 0; m < chain_masses; ++m) results.plane(m)[i] = positions[m];
              }
            };
          }};
}

ChainVector between(const ChainVector& a, const ChainVector& b, double t) {
  ChainVector result;
  for (std::size_t i = 0; i < chain_masses; ++i) result[i] = a[i] + t * (b[i] - a[i]);
  return result;
}

template <class Integrator>
Variant<double> integrated_chain(const char* name, int substeps) {
  return following_chain(std::string(name) + ", " + std::to_string(substeps), [substeps] {
    return [integrator = Integrator(chain_frame_seconds / substeps), motion = ChainMotion(), substeps](
               ChainVector& positions, const ChainVector& g0, const ChainVector& g1) mutable {
      for (int j = 0; j < substeps; ++j)
        integrator.step(motion, between(g0, g1, static_cast<double>(j) / substeps),
                        between(g0, g1, static_cast<double>(j + 1) / substeps));
      positions = motion.x;
    };
  });
}

SpringNet chain_net() {
  SpringNet net{.masses = chain_masses, .anchor = 1, .edges = {}, .damping = 2, .stiffness_damping = 1e-8};
  for (std::size_t i = 0; i + 1 < chain_masses; ++i)
    net.edges.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1), link_stiffness(i)});
  return net;
}

Displacements displacements(const ChainVector& along_x) {
  Displacements result;
  for (const double x : along_x) result.emplace_back(x, 0, 0);
  return result;
}

// The product's step, which moves in three dimensions.
Variant<double> shipped_tr_bdf2(int substeps) {
  Variant<double> variant = following_chain("TR-BDF2, " + std::to_string(substeps), [substeps] {
    const auto net = std::make_shared<const SpringNet>(chain_net());
    const auto stepper = std::make_shared<const morphcl::TrBdf2>(*net, EdgeRest::base, chain_frame_seconds / substeps);
    return [net, stepper, state = NetState{displacements({}), displacements({})}, substeps](
               ChainVector& positions, const ChainVector& g0, const ChainVector& g1) mutable {
      for (int j = 0; j < substeps; ++j)
        stepper->step(state, displacements(between(g0, g1, static_cast<double>(j) / substeps)),
                      displacements(between(g0, g1, static_cast<double>(j + 1) / substeps)));
      for (std::size_t i = 0; i < chain_masses; ++i) positions[i] = state.position[i].x;
    };
  });
  variant.ships = true;
  return variant;
}

// In its modes the chain is eight springs; each follows its share of the targets in closed form.
Variant<double> modal() {
  Variant<double> variant = following_chain("modal closed form", [] {
    const SpringNet net = chain_net();
    const auto modes = std::make_shared<const VibrationModes>(find_modes(net));
    std::vector<SpringStep> steps;
    for (const double stiffness : modes->stiffness) {
      const double omega = std::sqrt(stiffness);
      steps.emplace_back(Spring{omega, (net.damping + net.stiffness_damping * stiffness) / (2 * omega)},
                         chain_frame_seconds);
    }
    return [modes, steps, states = std::vector<SpringState>(chain_masses)](
               ChainVector& positions, const ChainVector& g0, const ChainVector& g1) mutable {
      positions = {};
      for (std::size_t m = 0; m < chain_masses; ++m) {
        const double* shape = modes->shape(m);
        double start = 0, end = 0;
        for (std::size_t i = 0; i < chain_masses; ++i) {
          start += shape[i] * g0[i];
          end += shape[i] * g1[i];
        }
        start /= modes->stiffness[m];
        end /= modes->stiffness[m];
        states[m] = steps[m].apply(states[m], Cubic{start, (end - start) / chain_frame_seconds, 0, 0});
        for (std::size_t i = 0; i < chain_masses; ++i) positions[i] += shape[i] * states[m].position;
      }
    };
  });
  variant.ships = true;
  return variant;
}

OperationReport run_chain(const Settings& settings, const Description& about) {
  PlanarOperation<double> op;
  op.about = about;
  op.results = chain_masses;
  op.families = {{"adversarial", "eight masses, links 100 times as stiff each, 10^12 in all; 24 frames",
                  [](Random& random, std::size_t count) {
                    return drawn(random, 1, count, {}, [](Random& r, double* in) { in[0] = r.integer(0, 1'000'000); });
                  }}};
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const auto positions = exact_chain<Number>(in(0, i), chain_frames);
    for (std::size_t m = 0; m < chain_masses; ++m) results[m] = {positions[m], Number(1)};
  });
  op.variants = {
      integrated_chain<ChainSymplecticEuler>("symplectic Euler", 64),
      integrated_chain<ChainImplicitEuler>("implicit Euler", 16),
      integrated_chain<ChainImplicitEuler>("implicit Euler", 256),
      integrated_chain<ChainTrapezoidal>("trapezoidal", 16),
      integrated_chain<ChainTrapezoidal>("trapezoidal", 256),
      integrated_chain<ChainBdf2>("BDF2", 16),
      integrated_chain<ChainBdf2>("BDF2", 256),
      shipped_tr_bdf2(1),
      shipped_tr_bdf2(16),
      shipped_tr_bdf2(64),
      modal(),
  };
  if (!settings.quick)
    op.variants.insert(op.variants.begin() + 1, integrated_chain<ChainSymplecticEuler>("symplectic Euler", 131072));
  op.compared = 8;
  op.batch = 1;
  op.steps_per_element = chain_frames;
  return run_planar(op, settings);
}

}  // namespace

Operation spring_chain() {
  const Description about = {.name = "spring-chain",
                             .title =
                                 "coupled springs with a stiffness ratio of 10^12; substeps a frame; times are for "
                                 "a frame",
                             .results = "the morph's unit",
                             .format = binary64,
                             .plotted = Measure::max_absolute,
                             .target = 1e-4,
                             .reason = "a tenth of a pixel where 1 is 1000 pixels"};
  return {about, [about](const Settings& settings) { return run_chain(settings, about); }};
}

}  // namespace morphcl::accuracy
