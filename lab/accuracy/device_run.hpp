// A variant's twin on the device: the batch's stored planes in a buffer, a kernel of lab/kernels, its
// results.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/accuracy/planes.hpp"
#include "morphcl/session.hpp"

namespace morphcl::accuracy {

// The three steps of a run; each is finished when it returns.
struct DeviceRun {
  std::function<void()> upload;      // inputs to the device
  std::function<void(int)> compute;  // the kernel, that many times
  std::function<void()> download;    // results to the host
};

using DevicePrepare = std::function<DeviceRun(Session&, const Batch&, Planes<float>& results)>;

// kernel(global const float* planes, global const T* constants, global float* results, uint count), one work-item an
// element; planes and results lie plane after plane. T is float, or double for a program that ends in _f64.
DevicePrepare kernel_run(const std::string& program, const std::string& kernel,
                         const std::function<std::vector<double>(const Batch&)>& constants);

}  // namespace morphcl::accuracy
