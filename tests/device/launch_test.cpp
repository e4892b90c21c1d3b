// Launches bind arguments by name and check what OpenCL would otherwise report late or not at all.
#include "host/device/launch.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "host/device/session_access.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using testing::shared_session;

const KernelSource launch_source = {"launch_test",
                                    "tests/device/launch_test.cpp",
                                    R"CL(
kernel void fill(global int* values, int value) { values[get_global_id(0)] = value; }
kernel void subtract(global const int* values, global const int* others, global int* results) {
  results[get_global_id(0)] = values[get_global_id(0)] - others[get_global_id(0)];
}
kernel void sum_of_group(global const int* values, local int* shared, global int* results) {
  shared[get_local_id(0)] = values[get_global_id(0)];
  barrier(CLK_LOCAL_MEM_FENCE);
  if (get_local_id(0) == 0) {
    int sum = 0;
    for (uint i = 0; i < get_local_size(0); ++i) sum += shared[i];
    results[get_group_id(0)] = sum;
  }
}
typedef struct { int factor; float offset; } Settings;
kernel void apply(global float* numbers, Settings settings) {
  numbers[get_global_id(0)] = numbers[get_global_id(0)] * settings.factor + settings.offset;
}
)CL",
                                    {{"fill", {{"values", "int"}, {"value", "int"}}},
                                     {"subtract", {{"values", "int"}, {"others", "int"}, {"results", "int"}}},
                                     {"sum_of_group", {{"values", "int"}, {"shared", "int"}, {"results", "int"}}},
                                     {"apply", {{"numbers", "float"}, {"settings", "Settings"}}}}};

using Values = Argument<cl_int, "values", "int">;
using Others = Argument<cl_int, "others", "int">;
using Results = Argument<cl_int, "results", "int">;
using Numbers = Argument<float, "numbers", "float">;
struct Settings {
  cl_int factor;
  cl_float offset;
};
using WronglyTyped = Argument<float, "values", "float">;

// What the compiler refuses.
template <class... Arguments>
concept CanLaunch = requires(const cl::CommandQueue& queue, const Kernel& kernel, const Arguments&... arguments) {
  launch(queue, kernel, cl::NDRange(1), cl::NDRange(1), arguments...);
};
static_assert(CanLaunch<DeviceBuffer<Values>, BufferAs<Others>, Named<cl_int>, LocalMemory>);
static_assert(!CanLaunch<cl::Buffer>, "a buffer without a meaning");
static_assert(!CanLaunch<SharedBuffer>, "a buffer without a meaning");
static_assert(!CanLaunch<cl_int>, "a value without a name");
template <class T>
concept CanBeNamed = requires(T value) { Named<T>{"value", value}; };
static_assert(CanBeNamed<cl_int> && !CanBeNamed<bool> && !CanBeNamed<const int*>, "no host pointers, no bool");

// Buffers of one element type and different meaning are different types; none becomes another.
static_assert(!std::is_same_v<DeviceBuffer<Values>, DeviceBuffer<Others>>);
static_assert(!std::is_convertible_v<DeviceBuffer<Values>, DeviceBuffer<Others>>);
static_assert(!std::is_constructible_v<DeviceBuffer<Others>, DeviceBuffer<Values>>);
static_assert(!std::is_assignable_v<DeviceBuffer<Others>&, DeviceBuffer<Values>>);
static_assert(!std::is_assignable_v<BufferAs<Others>&, BufferAs<Values>>);
static_assert(!std::is_convertible_v<cl::Buffer, BufferAs<Values>>, "a meaning is said, not guessed");
// Elements of another type neither go in nor come out.
template <class T>
concept CanBeMappedAs = requires(const DeviceBuffer<Values>& values, const cl::CommandQueue& queue, T* elements) {
  elements = values.map(queue, 1).data();
};
static_assert(CanBeMappedAs<cl_int> && !CanBeMappedAs<float> && !CanBeMappedAs<cl_uint>);

class Launch : public ::testing::Test {
 protected:
  // What is still compiling when the process ends crashes PoCL: LLVM's statics go before the session of all tests.
  void TearDown() override { queue().finish(); }
  Kernel kernel(const char* name) { return kernel_of(shared_session(), launch_source, name); }
  const cl::CommandQueue& queue() { return queue_of(shared_session()); }
  template <class Meaning>
  DeviceBuffer<Meaning> buffer(typename Meaning::Element first = {}) {
    DeviceBuffer<Meaning> made(context_of(shared_session()));
    made.map(queue(), 1)[0] = first;
    return made;
  }

  const cl::NDRange one{1};
  DeviceBuffer<Values> values = buffer<Values>(1);
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
  const auto results = buffer<Results>();
  const Kernel fill = kernel("fill"), sum = kernel("sum_of_group"), apply = kernel("apply");
  launch(queue(), fill, cl::NDRange(64), cl::NDRange(16), values, Named{"value", cl_int{7}});
  launch(queue(), sum, cl::NDRange(64), cl::NDRange(16), values, LocalMemory{"shared", 16 * sizeof(cl_int)}, results);
  {
    const auto sums = results.read(queue(), 4);
    for (const cl_int result : sums.span()) EXPECT_EQ(result, 7 * 16);
  }
  const auto numbers = buffer<Numbers>(3);
  launch(queue(), apply, one, one, numbers, Named{"settings", Settings{5, 0.25f}, "Settings"});
  EXPECT_EQ(numbers.read(queue(), 1)[0], 15.25f);
}

TEST_F(Launch, TheOrderDoesNotMatter) {
  const auto others = buffer<Others>(30);
  const auto results = buffer<Results>();
  values.map(queue(), 1)[0] = 100;
  const Kernel subtract = kernel("subtract");
  const auto result = [&] { return results.read(queue(), 1)[0]; };
  launch(queue(), subtract, one, one, values, others, results);
  EXPECT_EQ(result(), 70);
  results.map(queue(), 1)[0] = 0;
  launch(queue(), subtract, one, one, results, others, values);
  EXPECT_EQ(result(), 70);
  results.map(queue(), 1)[0] = 0;
  launch(queue(), subtract, one, one, BufferAs<Others>(others.buffer()), results, values);
  EXPECT_EQ(result(), 70);
}

TEST_F(Launch, AnEmptyRangeDoesNothing) {
  const Kernel fill = kernel("fill");
  launch(queue(), fill, cl::NDRange(0), one, values, Named{"value", cl_int{2}});
  launch(queue(), fill, cl::NDRange(4, 0), cl::NDRange(1, 1), values, Named{"value", cl_int{2}});
  EXPECT_EQ(values.read(queue(), 1)[0], 1);
}

TEST_F(Launch, ANameThatTheKernelLacksIsRefusedBeforeItRuns) {
  const Kernel fill = kernel("fill");
  expect_error(ErrorKind::internal, "kernel fill: it has no argument \"others\"",
               [&] { launch(queue(), fill, one, one, values, Named{"value", cl_int{2}}, buffer<Others>()); });
  expect_error(ErrorKind::internal, "kernel fill: it has no argument \"valu\"",
               [&] { launch(queue(), fill, one, one, values, Named{"valu", cl_int{2}}); });
  EXPECT_EQ(values.read(queue(), 1)[0], 1);
}

TEST_F(Launch, ANameThatIsMissingIsRefusedBeforeItRuns) {
  const Kernel fill = kernel("fill");
  expect_error(ErrorKind::internal, "kernel fill: argument \"value\" is missing",
               [&] { launch(queue(), fill, one, one, values); });
  expect_error(ErrorKind::internal, "kernel fill: argument \"values\" is missing",
               [&] { launch(queue(), fill, one, one, Named{"value", cl_int{2}}); });
  expect_error(ErrorKind::internal, "is missing", [&] { launch(queue(), fill, one, one); });
  EXPECT_EQ(values.read(queue(), 1)[0], 1);
}

// Also where the kernel object still has the argument from a launch before.
TEST_F(Launch, WhatALaunchBeforeGaveIsNotTakenAgain) {
  const Kernel fill = kernel("fill");
  launch(queue(), fill, one, one, values, Named{"value", cl_int{2}});
  expect_error(ErrorKind::internal, "is missing", [&] { launch(queue(), fill, one, one, values); });
}

TEST_F(Launch, ANameThatIsGivenTwiceIsRefusedBeforeItRuns) {
  const Kernel fill = kernel("fill");
  expect_error(ErrorKind::internal, "kernel fill: argument \"values\" is given twice",
               [&] { launch(queue(), fill, one, one, values, Named{"value", cl_int{2}}, buffer<Values>()); });
  EXPECT_EQ(values.read(queue(), 1)[0], 1);
}

TEST_F(Launch, AnotherTypeThanTheKernelDeclaresIsRefused) {
  const Kernel fill = kernel("fill");
  expect_error(ErrorKind::internal, "its argument \"values\" is of type int, and float was given",
               [&] { launch(queue(), fill, one, one, buffer<WronglyTyped>(), Named{"value", cl_int{2}}); });
  expect_error(ErrorKind::internal, "its argument \"value\" is of type int, and float was given",
               [&] { launch(queue(), fill, one, one, values, Named{"value", 2.0f}); });
}

// Drivers do not check the size of a struct, so its type is named (and each is declared in one header for both sides).
TEST_F(Launch, AStructOfAnotherTypeIsRefused) {
  const Kernel apply = kernel("apply");
  expect_error(ErrorKind::internal, "kernel apply: its argument \"settings\" is of type Settings, and Others was given",
               [&] { launch(queue(), apply, one, one, buffer<Numbers>(), Named{"settings", Settings{}, "Others"}); });
}
template <class... Values>
concept CanBeGivenAs = requires(Values... values) { Named{"settings", values...}; };
static_assert(CanBeGivenAs<Settings, std::string_view> && !CanBeGivenAs<Settings>, "a struct without its type");
static_assert(CanBeGivenAs<cl_int> && !CanBeGivenAs<cl_int, std::string_view>, "what has one type only");

TEST_F(Launch, AGroupThatDoesNotDivideTheRangeNamesKernelAndCode) {
  const Kernel fill = kernel("fill");
  const auto call = [&] { launch(queue(), fill, cl::NDRange(10), cl::NDRange(4), values, Named{"value", cl_int{1}}); };
  expect_error(ErrorKind::internal, "kernel fill", call);
  expect_error(ErrorKind::internal, "CL_INVALID_WORK_GROUP_SIZE (-54)", call);
}

// What the build found in the sources.
TEST(KernelSignatures, HaveNamesAndTypesInTheKernelsOrder) {
  const KernelSignature& vector = signature_of(kernel_source("self_test"), "self_test_vector");
  ASSERT_EQ(vector.arguments.size(), 5u);
  EXPECT_EQ(vector.arguments[0].name, "a_values");
  EXPECT_EQ(vector.arguments[0].type, "float");
  EXPECT_EQ(vector.arguments[3].name, "count");
  EXPECT_EQ(vector.arguments[3].type, "uint");
  // Made by a macro.
  const KernelSignature& transform = signature_of(kernel_source("transform_f64"), "transform_xyz");
  ASSERT_EQ(transform.arguments.size(), 4u);
  EXPECT_EQ(transform.arguments[1].name, "rows");
  EXPECT_EQ(transform.arguments[1].type, "double4");
}

TEST(KernelSignatures, NoKernelTakesMoreThanTwelveArguments) {
  for (const KernelSource& program : kernel_sources())
    for (const KernelSignature& kernel : program.kernels)
      EXPECT_LE(kernel.arguments.size(), 12u) << program.file << ": " << kernel.name;
}

// The driver knows the names where it builds from source.
TEST(KernelSignatures, AreThoseThatTheDriverKnows) {
  for (const KernelSource& program : kernel_sources()) {
    if (program.stage.ends_with("_f64") && !shared_session().info().fp64) continue;
    cl::Program built(context_of(shared_session()), program.text);
    built.build("-cl-std=CL1.2 -w -cl-kernel-arg-info");
    std::vector<cl::Kernel> kernels;
    built.createKernels(&kernels);
    EXPECT_EQ(kernels.size(), program.kernels.size()) << program.file;
    for (const cl::Kernel& kernel : kernels) {
      const KernelSignature& signature = signature_of(program, kernel.getInfo<CL_KERNEL_FUNCTION_NAME>());
      ASSERT_EQ(kernel.getInfo<CL_KERNEL_NUM_ARGS>(), signature.arguments.size()) << signature.name;
      for (cl_uint i = 0; i < signature.arguments.size(); ++i) {
        std::string name = kernel.getArgInfo<CL_KERNEL_ARG_NAME>(i);
        // PoCL gives names that are functions of OpenCL as well a prefix.
        if (name.starts_with("_cl_")) name.erase(0, 4);
        EXPECT_EQ(name, signature.arguments[i].name) << signature.name;
      }
    }
  }
}

}  // namespace
}  // namespace morphcl
