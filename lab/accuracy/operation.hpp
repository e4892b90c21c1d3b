// An operation whose error and run time are reported: what it is called, how it is judged, and what came out.
//
// To add one: a file in operations/ that makes an Operation, and its line in operations.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lab/accuracy/error_statistics.hpp"
#include "lab/accuracy/figures.hpp"
#include "lab/accuracy/timing.hpp"
#include "morphcl/session.hpp"

namespace morphcl::accuracy {

struct Description {
  std::string name;                    // "point-transform": of --operation, CSV and JSON
  std::string title;                   // one line: what is computed
  std::string results;                 // their unit
  Format format;                       // errors are counted in ulps of it
  Measure plotted;                     // what the plot shows and the target is about
  double target;                       // largest value that is good enough
  std::string reason;                  // what the target stands for
  std::string element = "an element";  // what a time is for, as the plots call it
};

struct Family {
  std::string name;  // "benign", "wide", "adversarial"
  std::string text;  // one line: what the inputs are
};

// One variant on one family.
struct Result {
  std::string family, variant;
  bool ships = false;        // morphcl itself computes it so
  bool c_library = false;    // its bits, and so its hash, may depend on the C library
  std::string place;         // "host" or "device": where the results come from
  std::size_t compared = 0;  // elements whose error was measured
  Figures figures;
  std::uint64_t hash = 0;   // of the results' bits
  std::string device_bits;  // "same" or "different" from the host's; "" when it was not run there
  std::vector<Timing> timings;

  // The smallest time of the first timing at `where`, ns per element; 0 when there is none.
  double nanoseconds(const std::string& where = "host") const;
};

struct OperationReport {
  Description about;
  std::vector<Family> families;
  std::vector<Result> results;   // family by family
  bool digits_confirmed = true;  // the reference with twice the digits gives every printed digit again
};

struct Settings {
  bool quick = false;
  std::uint64_t seed = 1;
  std::shared_ptr<Session> session;  // none: nothing is run on a device
};

struct Operation {
  Description about;
  std::function<OperationReport(const Settings&)> run;
};

// All of them, in the order of the report.
std::vector<Operation> all_operations();

}  // namespace morphcl::accuracy
