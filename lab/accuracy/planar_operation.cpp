#include "lab/accuracy/planar_operation.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphcl::accuracy {

namespace {

struct Level {
  const char* name;
  std::size_t factor;  // times the smallest batch
};
// Vertices of 24 bytes, 1024 of them: 24 KiB, 768 KiB and 96 MiB.
constexpr Level timed_levels[] = {{"L1", 1}, {"L2", 32}, {"memory", 4096}};

std::uint64_t seed_of(std::uint64_t seed, const std::string& operation, const std::string& family) {
  const std::string name = operation + "/" + family;
  return XXH3_64bits_withSeed(name.data(), name.size(), seed);
}

// Every NaN as the same one: which sign and payload an operation gives it is the processor's and the compiler's choice.
template <class Real>
std::uint64_t hash_of_planes(Planes<Real> planes) {
  for (Real& value : planes.values())
    if (std::isnan(value)) value = std::numeric_limits<Real>::quiet_NaN();
  return XXH3_64bits(planes.values().data(), planes.values().size() * sizeof(Real));
}

template <class Number>
using ExactPlanes = std::vector<ExactValue<Number>>;  // element by element

template <class Number>
ExactPlanes<Number> evaluate(const std::function<void(const Inputs&, std::size_t, ExactValue<Number>*)>& reference,
                             const Planes<double>& planes, const std::vector<double>& constants, std::size_t results) {
  const Inputs inputs(planes, constants);
  ExactPlanes<Number> exact(planes.size() * results);
  for (std::size_t i = 0; i < planes.size(); ++i) reference(inputs, i, exact.data() + i * results);
  return exact;
}

// The exact results for what was stored and for what was meant.
template <class Number>
struct Exact {
  ExactPlanes<Number> stored, truth;
};

template <class Real>
class FamilyRun {
 public:
  FamilyRun(const PlanarOperation<Real>& operation, const InputFamily& family, const Settings& settings)
      : operation_(operation), family_(family), settings_(settings) {}

  void run(OperationReport& report) {
    const std::size_t compared =
        std::max<std::size_t>(settings_.quick ? operation_.compared / 8 : operation_.compared, 1);
    batch_ = make(compared);
    const Reference& reference = *operation_.reference;
    wide_ = exact_results(reference.wide);
    doubled_ = exact_results(reference.doubled);
    const std::size_t first = report.results.size();
    for (const Variant<Real>& variant : operation_.variants) report.results.push_back(judged(variant, report));
    time_on_host(report.results.data() + first);
    if constexpr (std::is_same_v<Real, float>)
      if (settings_.session) run_on_device(report, first);
  }

 private:
  Batch make(std::size_t count) const {
    Random random(seed_of(settings_.seed, operation_.about.name, family_.name));
    return family_.make(random, count);
  }

  static Planes<double> read(const Batch& batch) {
    if constexpr (std::is_same_v<Real, float>)
      return converted<double>(batch.stored);
    else
      return batch.truth;
  }

  template <class Function>
  auto exact_results(const Function& reference) const {
    using Number = typename std::remove_cvref_t<decltype(evaluate(reference, batch_.truth, batch_.constants,
                                                                  1))>::value_type::Number;
    Exact<Number> exact;
    exact.stored = evaluate(reference, read(batch_), batch_.constants, operation_.results);
    if constexpr (std::is_same_v<Real, float>)
      exact.truth = evaluate(reference, batch_.truth, batch_.constants, operation_.results);
    return exact;
  }

  Planes<Real> compute(const Variant<Real>& variant, const Batch& batch) const {
    Planes<Real> results(operation_.results, batch.size());
    variant.prepare(batch)(results);
    return results;
  }

  template <class Number>
  Figures figures(const Planes<Real>& results, const ExactPlanes<Number>& stored,
                  const ExactPlanes<Number>& truth) const {
    ErrorStatistics errors(operation_.about.format), true_errors(operation_.about.format);
    EventCounts events;
    const std::size_t measured = std::min(operation_.measured, operation_.results);
    std::vector<double> computed(operation_.results), exact(operation_.results);
    for (std::size_t i = 0; i < results.size(); ++i) {
      for (std::size_t r = 0; r < operation_.results; ++r) {
        const std::size_t at = i * operation_.results + r;
        computed[r] = static_cast<double>(results.plane(r)[i]);
        exact[r] = static_cast<double>(stored[at].value);
        if (r >= measured) continue;
        errors.add(computed[r], stored[at]);
        if (!truth.empty()) true_errors.add(computed[r], truth[at]);
      }
      if (operation_.judge) operation_.judge(computed.data(), exact.data(), events);
    }
    Figures figures;
    if (measured > 0) errors.write(figures);
    if (measured > 0 && !truth.empty()) figures[Measure::max_true] = true_errors.max_absolute();
    if (!operation_.relative)
      for (const Measure measure : {Measure::max_ulp, Measure::rms_ulp, Measure::max_scaled})
        figures[measure] = std::numeric_limits<double>::quiet_NaN();
    events.write(figures, operation_.events, results.size());
    return figures;
  }

  template <class Number, class Function>
  Figures figures_of(const Variant<Real>& variant, const Planes<Real>& results, const Exact<Number>& exact,
                     const Function& reference) const {
    Figures all = figures(results, exact.stored, exact.truth);
    const double error_of_stored = all[Measure::max_absolute];
    if (variant.stored)
      all = figures(results, evaluate(reference, variant.stored(batch_), batch_.constants, operation_.results),
                    exact.truth);
    if (family_.pixels_per_unit > 0) all[Measure::max_pixels] = error_of_stored * family_.pixels_per_unit;
    return all;
  }

  void judge(const Variant<Real>& variant, const Planes<Real>& results, Result& result, OperationReport& report) const {
    result.compared = results.size();
    result.hash = hash_of_planes(results);
    result.figures = figures_of(variant, results, wide_, operation_.reference->wide);
    const Figures again = figures_of(variant, results, doubled_, operation_.reference->doubled);
    report.digits_confirmed = report.digits_confirmed && same_digits(result.figures, again);
  }

  Result empty_result(const Variant<Real>& variant, const char* place) const {
    Result result;
    result.family = family_.name;
    result.variant = variant.name;
    result.ships = variant.ships;
    result.c_library = variant.c_library;
    result.place = place;
    return result;
  }

  Result judged(const Variant<Real>& variant, OperationReport& report) const {
    Result result = empty_result(variant, "host");
    judge(variant, compute(variant, batch_), result, report);
    return result;
  }

  TimingPlan timing_plan() const {
    return settings_.quick ? TimingPlan{.runs = 30, .shortest_run_ns = 5'000}
                           : TimingPlan{.runs = 60, .shortest_run_ns = 50'000};
  }

  void time_on_host(Result* results) const {
    for (const Level& level : timed_levels) {
      if (level.factor > 1 && (settings_.quick || !operation_.streams)) break;
      const Batch batch = make(operation_.batch * level.factor);
      Planes<Real> out(operation_.results, batch.size());
      for (std::size_t v = 0; v < operation_.variants.size(); ++v) {
        const auto run = operation_.variants[v].prepare(batch);
        Timing timing = time_batch([&] { run(out); }, batch.size(), timing_plan());
        timing.level = level.name;
        timing.minimum_ns /= operation_.steps_per_element;
        timing.median_ns /= operation_.steps_per_element;
        results[v].timings.push_back(timing);
      }
    }
  }

  // Every twin on a large batch, whose start is the batch that is compared; a twin whose bits differ from the host's is
  // a result of its own.
  void run_on_device(OperationReport& report, std::size_t first) const {
    const bool any = std::any_of(operation_.variants.begin(), operation_.variants.end(),
                                 [](const Variant<Real>& variant) { return variant.device != nullptr; });
    if (!any) return;
    const std::size_t count = std::max(batch_.size(), std::size_t{1} << (settings_.quick ? 16 : 20));
    const Batch batch = make(count);
    for (std::size_t v = 0; v < operation_.variants.size(); ++v) {
      const Variant<Real>& variant = operation_.variants[v];
      if (!variant.device) continue;
      Planes<Real> results(operation_.results, count);
      const DeviceRun run = variant.device(*settings_.session, batch, results);
      run.upload();
      run.compute(1);
      run.download();
      const bool same = same_bits(results, compute(variant, batch));
      std::size_t at = first + v;
      report.results[at].device_bits = same ? "same" : "different";
      if (!same) {
        Result result = empty_result(variant, "device");
        judge(variant, start_of(results, batch_.size()), result, report);
        at = report.results.size();
        report.results.push_back(std::move(result));
      }
      time_on_device(run, count, report.results[at].timings);
    }
  }

  void time_on_device(const DeviceRun& run, std::size_t count, std::vector<Timing>& timings) const {
    constexpr int launches = 4;
    TimingPlan plan = timing_plan();
    plan.shortest_run_ns = 0;
    Timing kernel = time_batch([&] { run.compute(launches); }, count * launches, plan);
    kernel.elements = count;
    kernel.where = "device";
    Timing all = time_batch(
        [&] {
          run.upload();
          run.compute(1);
          run.download();
        },
        count, plan);
    all.where = "device+transfer";
    kernel.level = all.level = settings_.quick ? "L2" : "memory";
    timings.push_back(kernel);
    timings.push_back(all);
  }

  // NaN are equal whatever their payload, which no standard promises.
  static bool same_bits(const Planes<Real>& a, const Planes<Real>& b) {
    return std::equal(a.values().begin(), a.values().end(), b.values().begin(), [](Real x, Real y) {
      return (std::isnan(x) && std::isnan(y)) || (x == y && std::signbit(x) == std::signbit(y));
    });
  }

  static Planes<Real> start_of(const Planes<Real>& planes, std::size_t count) {
    Planes<Real> start(planes.planes(), count);
    for (std::size_t p = 0; p < planes.planes(); ++p) std::copy_n(planes.plane(p), count, start.plane(p));
    return start;
  }

  const PlanarOperation<Real>& operation_;
  const InputFamily& family_;
  const Settings& settings_;
  Batch batch_;
  Exact<Wide> wide_;
  Exact<Doubled> doubled_;
};

}  // namespace

void EventCounts::write(Figures& figures, const std::vector<Measure>& events, std::size_t elements) const {
  for (const Measure event : events) {
    const auto found = counts_.find(event);
    const double count = found == counts_.end() ? 0 : static_cast<double>(found->second);
    figures[event] = 1e6 * count / static_cast<double>(elements);
  }
}

template <class Real>
OperationReport run_planar(const PlanarOperation<Real>& operation, const Settings& settings) {
  OperationReport report;
  report.about = operation.about;
  for (const InputFamily& family : operation.families) {
    report.families.push_back({family.name, family.text});
    FamilyRun<Real>(operation, family, settings).run(report);
  }
  return report;
}

template OperationReport run_planar(const PlanarOperation<float>&, const Settings&);
template OperationReport run_planar(const PlanarOperation<double>&, const Settings&);

}  // namespace morphcl::accuracy
