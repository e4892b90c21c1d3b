// morphcl accuracy: the error of every operation against its run time, in every variant.
#pragma once

#include <string>
#include <vector>

#include "cli/open_renderer.hpp"

namespace morphcl::cli {

struct AccuracyOptions {
  std::string out;                      // folder for accuracy.csv, .json and .svg; "" none is written
  std::vector<std::string> operations;  // names; none: all
  bool quick = false;
  bool json = false;
  bool verbose = false;  // tables of all variants
  std::string seed = "1";
  DeviceOptions device;  // "none": nothing is run on a device
};

int accuracy_command(const AccuracyOptions& options);

}  // namespace morphcl::cli
