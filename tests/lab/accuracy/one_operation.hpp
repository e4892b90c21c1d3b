// The quick report of one operation on the host, and one of its results.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lab/accuracy/report.hpp"

namespace morphcl::accuracy::testing {

inline OperationReport quick_report(const std::string& operation, std::uint64_t seed = 1) {
  Settings settings;
  settings.quick = true;
  settings.seed = seed;
  return run_report(settings, {operation}, 0, [](const std::string&, std::size_t, std::size_t) {}).operations.at(0);
}

inline const Result& result_of(const OperationReport& report, const std::string& family, const std::string& variant) {
  const auto found = std::find_if(report.results.begin(), report.results.end(), [&](const Result& result) {
    return result.family == family && result.variant == variant;
  });
  if (found == report.results.end())
    throw std::runtime_error(report.about.name + " has no '" + variant + "' on " + family);
  return *found;
}

inline double figure(const OperationReport& report, const std::string& family, const std::string& variant,
                     Measure measure) {
  const Figures& figures = result_of(report, family, variant).figures;
  EXPECT_TRUE(figures.has(measure)) << variant << " has no " << text_of(measure).name;
  return figures[measure];
}

}  // namespace morphcl::accuracy::testing
