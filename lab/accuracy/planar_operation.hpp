// Operations whose elements do not depend on each other: families of inputs, an exact reference, variants.
//
// Real is the type of the results' planes: float for what runs on vertices and pixels by the million, double for what
// the host computes a frame. A variant is five lines: a name and a function that prepares it for a batch (composes its
// matrix, say) and returns the loop that is timed.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lab/accuracy/device_run.hpp"
#include "lab/accuracy/operation.hpp"
#include "lab/accuracy/planes.hpp"
#include "lab/accuracy/random.hpp"

namespace morphcl::accuracy {

// What a reference reads: plane p of element i, and the numbers that all elements share.
class Inputs {
 public:
  Inputs(const Planes<double>& planes, const std::vector<double>& constants) : planes_(planes), constants_(constants) {}
  double operator()(std::size_t p, std::size_t i) const { return planes_.plane(p)[i]; }
  double constant(std::size_t c) const { return constants_[c]; }

 private:
  const Planes<double>& planes_;
  const std::vector<double>& constants_;
};

// The exact results of element i in both precisions, from one function that is generic in the number:
//   [](const Inputs& in, std::size_t i, auto* results) { using Number = NumberOf<decltype(results)>; ... }
template <class Pointer>
using NumberOf = typename std::remove_pointer_t<Pointer>::Number;

struct Reference {
  template <class Function>
  Reference(Function function)  // NOLINT: functions are references
      : wide([function](const Inputs& in, std::size_t i, ExactValue<Wide>* results) { function(in, i, results); }),
        doubled(
            [function](const Inputs& in, std::size_t i, ExactValue<Doubled>* results) { function(in, i, results); }) {}

  std::function<void(const Inputs&, std::size_t, ExactValue<Wide>*)> wide;
  std::function<void(const Inputs&, std::size_t, ExactValue<Doubled>*)> doubled;
};

// Events among the elements, reported per million of them.
class EventCounts {
 public:
  void count(Measure event) { ++counts_[event]; }
  void write(Figures& figures, const std::vector<Measure>& events, std::size_t elements) const;

 private:
  std::map<Measure, std::size_t> counts_;
};

template <class Real>
struct Variant {
  using Run = std::function<void(Planes<Real>& results)>;

  std::string name;
  std::function<Run(const Batch&)> prepare;
  bool ships = false;                                            // morphcl computes it so
  std::function<Planes<double>(const Batch&)> stored = nullptr;  // what it reads instead of the batch's stored planes
  DevicePrepare device = nullptr;                                // its twin on the device
  bool c_library = false;  // calls functions of the C library that are not correctly rounded
};

struct InputFamily {
  std::string name, text;
  std::function<Batch(Random&, std::size_t count)> make;  // a smaller batch is the start of a larger one
  double pixels_per_unit = 0;                             // 0: results have no size on a screen
};

constexpr std::size_t all_results = ~std::size_t{0};

template <class Real>
struct PlanarOperation {
  Description about;
  std::size_t results = 1;             // planes
  std::size_t measured = all_results;  // the first so many have an error; the others are decisions for judge()
  bool relative = true;                // false: ulps and scaled errors would say nothing
  std::vector<InputFamily> families;
  std::optional<Reference> reference;
  std::vector<Variant<Real>> variants;

  bool streams = false;              // batches of every size are timed
  std::size_t compared = 4096;       // elements; by --quick an eighth of it
  std::size_t batch = 1024;          // elements of the smallest batch that is timed
  double steps_per_element = 1;      // times are given per step: frames of a spring, factors of a product
  std::vector<Measure> events = {};  // that judge() counts
  // What went wrong with an element, from its computed and exact results.
  std::function<void(const double* computed, const double* exact, EventCounts&)> judge = nullptr;
};

template <class Real>
OperationReport run_planar(const PlanarOperation<Real>& operation, const Settings& settings);
extern template OperationReport run_planar(const PlanarOperation<float>&, const Settings&);
extern template OperationReport run_planar(const PlanarOperation<double>&, const Settings&);

template <class Real>
Operation operation_of(PlanarOperation<Real> planar) {
  const Description about = planar.about;
  return {about, [planar = std::move(planar)](const Settings& settings) { return run_planar(planar, settings); }};
}

// A batch of `planes` inputs drawn by fill(random, element), element by element.
template <class Fill>
Batch drawn(Random& random, std::size_t planes, std::size_t count, std::vector<double> constants, Fill&& fill) {
  Batch batch;
  batch.truth = Planes<double>(planes, count);
  batch.constants = std::move(constants);
  std::vector<double> element(planes);
  for (std::size_t i = 0; i < count; ++i) {
    fill(random, element.data());
    for (std::size_t p = 0; p < planes; ++p) batch.truth.plane(p)[i] = element[p];
  }
  batch.stored = converted<float>(batch.truth);
  return batch;
}

// Inputs that are binary32 numbers, so that all variants read the same; draw(random, element) before they are rounded.
template <class Draw>
InputFamily binary32_family(const char* name, const char* text, std::size_t planes, Draw draw) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, planes, count, {}, [=](Random& r, double* in) {
              draw(r, in);
              for (std::size_t p = 0; p < planes; ++p) in[p] = static_cast<float>(in[p]);
            });
          }};
}

}  // namespace morphcl::accuracy
