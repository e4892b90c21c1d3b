// What `#pragma OPENCL FP_CONTRACT OFF` at the head of every kernel is for.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/device/kernel_source.hpp"
#include "host/device/session_access.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "tests/device/kernel_libraries.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

const std::string pragma = "#pragma OPENCL FP_CONTRACT OFF\n";

TEST(FpContract, IsOffInEveryKernelFile) {
  for (const KernelSource& source : kernel_sources()) EXPECT_TRUE(source.text.starts_with(pragma)) << source.file;
}

TEST(FpContract, WithoutThePragmaTheBitsChange) {
  shared_session();  // prepares the process
  const std::vector<std::string> libraries = testing::kernel_libraries_that_run_here();
  const bool has_fma = std::find(libraries.begin(), libraries.end(), "avx2") != libraries.end();
  SessionOptions options;
  options.cache_dir = "-";
  // The self-test is left as it is: it refuses a device that contracts.
  const std::string& self_test = kernel_source("self_test").text;
  const auto session =
      open_session(options, [&](std::string text) { return text == self_test ? text : text.erase(0, pragma.size()); });
  const auto contracted = make_device_renderer(session), reference = make_reference_renderer();
  bool same = true;
  for (const TestScene& test : test_scenes(200, 150)) {
    const Plan plan = plan_frame(test.scene, test.frames[0]);
    FrameBuffer expected(plan->width, plan->height, {Channel::color, Channel::depth}),
        actual(plan->width, plan->height, {Channel::color, Channel::depth});
    reference->render(plan, expected);
    contracted->render(plan, actual);
    if (!same_pixels(expected, actual)) {
      same = false;
      break;
    }
  }
  // A processor without fma has nothing to contract to.
  EXPECT_EQ(same, !has_fma);
}

}  // namespace
}  // namespace morphcl::test
