// Launches check what OpenCL would otherwise report late or not at all.
#include "host/device/launch.hpp"

#include <gtest/gtest.h>

#include "host/device/shared_buffer.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using testing::shared_session;

constexpr const char* launch_source = R"CL(
kernel void fill(global int* values, int value) { values[get_global_id(0)] = value; }
kernel void sum_of_group(global const int* values, local int* shared, global int* sums) {
  shared[get_local_id(0)] = values[get_global_id(0)];
  barrier(CLK_LOCAL_MEM_FENCE);
  if (get_local_id(0) == 0) {
    int sum = 0;
    for (uint i = 0; i < get_local_size(0); ++i) sum += shared[i];
    sums[get_group_id(0)] = sum;
  }
}
typedef struct { int factor; float offset; } Settings;
kernel void apply(global float* values, Settings settings) {
  values[get_global_id(0)] = values[get_global_id(0)] * settings.factor + settings.offset;
}
)CL";

class Launch : public ::testing::Test {
 protected:
  Launch() : program(shared_session().context(), launch_source), buffer(shared_session().context()) { program.build(); }

  cl::Kernel kernel(const char* name) { return cl::Kernel(program, name); }
  const cl::CommandQueue& queue() { return shared_session().queue(); }

  cl::Program program;
  SharedBuffer buffer;
};

template <class Call>
void expect_error(ErrorKind kind, const std::string& part, Call call) {
  try {
    call();
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST_F(Launch, PassesBuffersValuesStructsAndLocalMemory) {
  cl::Kernel fill = kernel("fill"), sum = kernel("sum_of_group");
  SharedBuffer sums(shared_session().context());
  launch(queue(), fill, cl::NDRange(64), cl::NDRange(16), buffer.buffer(), cl_int{7});
  launch(queue(), sum, cl::NDRange(64), cl::NDRange(16), buffer.buffer(), LocalMemory{16 * sizeof(cl_int)},
         sums.buffer());
  {
    const auto results = sums.map<const cl_int>(queue(), 4);
    for (const cl_int result : results.span()) EXPECT_EQ(result, 7 * 16);
  }

  struct Settings {
    cl_int factor;
    cl_float offset;
  };
  buffer.map<float>(queue(), 1)[0] = 3;
  cl::Kernel apply = kernel("apply");
  launch(queue(), apply, cl::NDRange(1), cl::NDRange(1), buffer.buffer(), Settings{5, 0.25f});
  EXPECT_EQ(buffer.map<const float>(queue(), 1)[0], 15.25f);
}

TEST_F(Launch, AnEmptyRangeDoesNothing) {
  cl::Kernel fill = kernel("fill");
  buffer.map<cl_int>(queue(), 1)[0] = 1;
  launch(queue(), fill, cl::NDRange(0), cl::NDRange(1), buffer.buffer(), cl_int{2});
  launch(queue(), fill, cl::NDRange(4, 0), cl::NDRange(1, 1), buffer.buffer(), cl_int{2});
  EXPECT_EQ(buffer.map<const cl_int>(queue(), 1)[0], 1);
}

TEST_F(Launch, AWrongNumberOfArgumentsNamesKernelAndNumbers) {
  cl::Kernel fill = kernel("fill");
  const cl::NDRange one(1);
  expect_error(ErrorKind::internal, "kernel fill takes 2 arguments, 1 were given",
               [&] { launch(queue(), fill, one, one, buffer.buffer()); });
  expect_error(ErrorKind::internal, "kernel fill takes 2 arguments, 3 were given",
               [&] { launch(queue(), fill, one, one, buffer.buffer(), cl_int{1}, cl_int{1}); });
}

TEST_F(Launch, AnArgumentOfWrongSizeNamesKernelAndCode) {
  cl::Kernel fill = kernel("fill");
  const cl::NDRange one(1);
  expect_error(ErrorKind::internal, "kernel fill",
               [&] { launch(queue(), fill, one, one, buffer.buffer(), cl_double{1}); });
  expect_error(ErrorKind::internal, "CL_INVALID_ARG_SIZE",
               [&] { launch(queue(), fill, one, one, buffer.buffer(), cl_double{1}); });
}

TEST_F(Launch, AGroupThatDoesNotDivideTheRangeNamesKernelAndCode) {
  cl::Kernel fill = kernel("fill");
  const auto call = [&] { launch(queue(), fill, cl::NDRange(10), cl::NDRange(4), buffer.buffer(), cl_int{1}); };
  expect_error(ErrorKind::internal, "kernel fill", call);
  expect_error(ErrorKind::internal, "CL_INVALID_WORK_GROUP_SIZE (-54)", call);
}

}  // namespace
}  // namespace morphcl
