// The self-test must pass on a right device and name every operation that a wrong one gets wrong.
#include "host/device/self_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>

#include "host/device/kernel_source.hpp"
#include "host/device/self_test_reference.hpp"
#include "host/device/session_access.hpp"
#include "morphcl/error.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using testing::shared_session;

std::string self_test_source() { return kernel_source("self_test").text; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  EXPECT_NE(text.find(from), std::string::npos) << "nothing to break: \"" << from << "\" is not in the kernel";
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

SelfTestResult run_source(const std::string& source, const std::string& options) {
  Session& session = shared_session();
  cl::Program program(context_of(session), source);
  program.build(options.c_str());
  const auto kernel = [&](const char* name) {
    return Kernel(cl::Kernel(program, name), signature_of(kernel_source("self_test"), name));
  };
  return run_self_test(context_of(session), queue_of(session), kernel("self_test_scalar"), kernel("self_test_vector"));
}

constexpr const char* strict_options = "-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt";

TEST(SelfTestOnDevice, DefaultDeviceIsIdentical) {
  EXPECT_EQ(shared_session().verdict(), Verdict::identical) << shared_session().verdict_detail();
  EXPECT_EQ(shared_session().verdict_detail(), "");
}

TEST(SelfTestOnDevice, RunAfreshItIsIdenticalToo) {
  const SelfTestResult result = run_source(self_test_source(), strict_options);
  EXPECT_EQ(result.verdict, Verdict::identical) << result.detail;
}

bool processor_has_fma() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("flags")) return (line + " ").find(" fma ") != std::string::npos;
  return true;  // fused multiply-add belongs to the base instruction set elsewhere
}

// What the pragma at the head of every kernel file is for.
TEST(SelfTestOnDevice, WithoutFpContractOffProductsAndSumsAreFused) {
  const SelfTestResult result =
      run_source(replaced(self_test_source(), "#pragma OPENCL FP_CONTRACT OFF\n", ""), strict_options);
  const bool fused = processor_has_fma() && shared_session().info().is_cpu;
  EXPECT_EQ(result.verdict, fused ? Verdict::tolerant : Verdict::identical);
  EXPECT_EQ(result.detail.find("a*b+c") != std::string::npos, fused) << result.detail;
}

std::shared_ptr<Session> open_with_defect(const std::string& from, const std::string& to) {
  SessionOptions options;
  options.cache_dir = "/proc/none";
  return open_session(
      options, [&](const std::string& text) { return text == self_test_source() ? replaced(text, from, to) : text; });
}

TEST(SelfTestOnDevice, ADeviceThatRoundsDifferentlyIsTolerant) {
  const auto session = open_with_defect("convert_float_rte", "convert_float_rtz");
  EXPECT_EQ(session->verdict(), Verdict::tolerant);
  EXPECT_NE(session->verdict_detail().find("int to float on one float: "), std::string::npos);
  EXPECT_EQ(session->cache_trouble(), "");
  session->store_programs();
  EXPECT_NE(session->cache_trouble().find("/proc/none"), std::string::npos) << "what was compiled is lost";
}

TEST(SelfTestOnDevice, ADeviceThatComputesWrongIsNotOpened) {
  try {
    open_with_defect("fma(a, b, c)", "a * b + c");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    EXPECT_NE(error.message().find("fma on one float: "), std::string::npos) << error.message();
  }
}

struct Defect {
  const char* name;
  const char* from;
  const char* to;
  const char* options;
  const char* reported;

  friend std::ostream& operator<<(std::ostream& out, const Defect& defect) { return out << defect.name; }
};

class SelfTestDefects : public ::testing::TestWithParam<Defect> {};

TEST_P(SelfTestDefects, IsReported) {
  const Defect& defect = GetParam();
  const SelfTestResult result = run_source(replaced(self_test_source(), defect.from, defect.to), defect.options);
  EXPECT_EQ(result.verdict, Verdict::tolerant);
  EXPECT_NE(result.detail.find(defect.reported), std::string::npos) << "reported: " << result.detail;
}

INSTANTIATE_TEST_SUITE_P(
    EveryOperation, SelfTestDefects,
    ::testing::Values(
        Defect{"NegativeZeroSum", "(a + b)", "(a + b + 0.0f)", strict_options, "a+b on"},
        Defect{"SwappedDifference", "(a - b)", "(-(b - a))", strict_options, "a-b on"},
        Defect{"NegativeZeroProduct", "(a * b)", "(a * b + 0.0f)", strict_options, "a*b on"},
        Defect{"DivisionByReciprocal", "(a / b)", "(a * (1.0f / b))", strict_options, "a/b on"},
        Defect{"RootByReciprocalRoot", "sqrt(fabs(a))", "1.0f / rsqrt(fabs(a))", strict_options, "sqrt on"},
        Defect{"UnfusedFma", "fma(a, b, c)", "a * b + c", strict_options, "fma on"},
        Defect{"FusedProductAndSum", "(a * b + c)", "(fma(a, b, c))", strict_options, "a*b+c on"},
        Defect{"HalfTowardsZero", "vstore_half16(", "vstore_half16_rtz(", strict_options, "float to half on"},
        Defect{"NegativeZeroHalf", "vload_half16(0, (half*)halves)", "vload_half16(0, (half*)halves) + 0.0f",
               strict_options, "half to float on"},
        Defect{"IntTowardsZero", "convert_float_rte", "convert_float_rtz", strict_options, "int to float on one"},
        Defect{"IntsTowardsZero", "convert_float16_rte", "convert_float16_rtz", strict_options, "int to float on 16"},
        Defect{"FloatTowardsZero", "convert_int_sat_rte", "convert_int_sat_rtz", strict_options, "float to int on one"},
        Defect{"FloatsTowardsZero", "convert_int16_sat_rte", "convert_int16_sat_rtz", strict_options,
               "float to int on 16"},
        Defect{"SumsTakenForAssociative", "((a + b) - a)", "(b)", strict_options, "a+b-a on"},
        Defect{"FactorsCancelled", "(a * b / b)", "(a)", strict_options, "a*b/b on"},
        Defect{"FlushedDenormals", "(a * b)", "(a * b)",
               "-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt -cl-denorms-are-zero", "a*b on"}),
    [](const auto& defect) { return std::string(defect.param.name); });

std::uint32_t half_answer(float value) { return self_test_answer(SelfTest::float_to_half, value, 0, 0); }

TEST(SelfTestReference, HalvesRoundToNearestEven) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const struct {
    float value;
    std::uint32_t half;
  } cases[] = {{0.0f, 0x0000},       {-0.0f, 0x8000},      {1.0f, 0x3c00},         {-2.0f, 0xc000},
               {65504.0f, 0x7bff},   {65519.996f, 0x7bff}, {65520.0f, 0x7c00},     {-infinity, 0xfc00},
               {0x1p-14f, 0x0400},   {0x1p-24f, 0x0001},   {0x1p-25f, 0x0000},     {0x1.000002p-25f, 0x0001},
               {0x1.8p-24f, 0x0002}, {0x1.004p0f, 0x3c01}, {0x1.002p0f, 0x3c00},   {0x1.006p0f, 0x3c02},
               {0x1p-149f, 0x0000},  {0x1p16f, 0x7c00},    {0x1.ff8p-15f, 0x03ff}, {0x1.ffcp-15f, 0x0400}};
  for (const auto& c : cases) EXPECT_EQ(half_answer(c.value), c.half) << std::hexfloat << c.value;
}

// half -> float is exact, and the halves around a float decide what it rounds to.
TEST(SelfTestReference, EveryHalfAndEveryMidpointBetweenHalves) {
  const auto value = [](std::uint32_t half) {
    const float carrier = std::bit_cast<float>(half);  // the low bits name the half, the sign bit is 0
    return std::bit_cast<float>(self_test_answer(SelfTest::half_to_float, carrier, 0, 0));
  };
  for (std::uint32_t half = 0; half < 0x7c00; ++half) {
    const float here = value(half), next = half + 1 < 0x7c00 ? value(half + 1) : 65536.0f;
    ASSERT_EQ(half_answer(here), half);
    ASSERT_EQ(half_answer(-here), half | 0x8000);
    const float middle = here + (next - here) / 2;  // exact
    ASSERT_EQ(half_answer(middle), half + (half & 1)) << "between halves " << half << " and " << half + 1;
    ASSERT_EQ(half_answer(std::nextafter(middle, 0.0f)), half);
    ASSERT_EQ(half_answer(std::nextafter(middle, 65536.0f)), half + 1);
  }
}

TEST(SelfTestReference, DistanceCountsUlpAndSignsOfZero) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  EXPECT_EQ(self_test_distance(SelfTest::sum, bits(1.0f), bits(1.0f)), 0u);
  EXPECT_EQ(self_test_distance(SelfTest::sum, bits(1.0f), bits(0x1.000004p0f)), 2u);
  EXPECT_EQ(self_test_distance(SelfTest::sum, bits(0x1p-149f), bits(-0x1p-149f)), 2u);
  EXPECT_EQ(self_test_distance(SelfTest::sum, bits(0.0f), bits(-0.0f)), 1u);
  EXPECT_EQ(self_test_distance(SelfTest::sum, 0x7fc00000, 0xffc00001), 0u);
  EXPECT_GT(self_test_distance(SelfTest::sum, 0x7fc00000, bits(1.0f)), 0u);
  EXPECT_EQ(self_test_distance(SelfTest::float_to_half, 0x0000, 0x8000), 1u);
  EXPECT_EQ(self_test_distance(SelfTest::float_to_int, static_cast<std::uint32_t>(-1), 1), 2u);
}

TEST(SelfTestReference, OperandsHoldTheCasesThatMatter) {
  const SelfTestOperands operands = self_test_operands();
  ASSERT_EQ(operands.a.size(), self_test_elements);
  ASSERT_EQ(operands.b.size(), self_test_elements);
  ASSERT_EQ(operands.c.size(), self_test_elements);
  std::size_t fused_differs = 0, denormal_products = 0, negative_zero_sums = 0;
  for (std::size_t i = 0; i < self_test_elements; ++i) {
    const float a = operands.a[i], b = operands.b[i], c = operands.c[i];
    ASSERT_FALSE(std::isnan(a) || std::isnan(b) || std::isnan(c)) << i;
    fused_differs += std::fma(a, b, c) != a * b + c;
    denormal_products += std::fpclassify(a * b) == FP_SUBNORMAL;
    negative_zero_sums += a + b == 0 && std::signbit(a + b);
  }
  EXPECT_GE(fused_differs, 100u);
  EXPECT_GE(denormal_products, 10u);
  EXPECT_GE(negative_zero_sums, 1u);
}

}  // namespace
}  // namespace morphcl
