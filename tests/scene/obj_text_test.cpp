// Statements and numbers of .obj files.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "host/scene/obj/obj_text.hpp"

namespace morphcl::test {
namespace {

using Big = boost::multiprecision::cpp_rational;

// The exact value of a decimal text like "-12.5e-3", by whole-number arithmetic.
Big exact(const std::string& text) {
  boost::multiprecision::cpp_int digits = 0, ten = 10;
  int exponent = 0;
  bool fraction = false;
  std::size_t i = text[0] == '-' || text[0] == '+' ? 1 : 0;
  for (; i < text.size() && text[i] != 'e'; ++i) {
    if (text[i] == '.') {
      fraction = true;
      continue;
    }
    digits = digits * 10 + (text[i] - '0');
    exponent -= fraction ? 1 : 0;
  }
  if (i < text.size()) exponent += std::stoi(text.substr(i + 1));
  const auto power = boost::multiprecision::pow(ten, static_cast<unsigned>(std::abs(exponent)));
  const Big value = exponent < 0 ? Big(digits, power) : Big(digits * power);
  return text[0] == '-' ? Big(-value) : value;
}

Big exact(float value) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 24));
  exponent -= 24;
  const boost::multiprecision::cpp_int power = boost::multiprecision::cpp_int(1) << std::abs(exponent);
  return exponent < 0 ? Big(mantissa, power) : Big(mantissa * power);
}

// Correctly rounded: no neighbour is nearer, and of two equally near ones the even one is taken.
void expect_nearest(const std::string& text) {
  const std::optional<float> value = parse_float(text);
  ASSERT_TRUE(value) << text;
  const float infinity = std::numeric_limits<float>::infinity();
  const Big want = exact(text), error = abs(exact(*value) - want);
  for (const float neighbour : {std::nextafter(*value, infinity), std::nextafter(*value, -infinity)}) {
    if (std::isinf(neighbour)) continue;
    const Big other = abs(exact(neighbour) - want);
    EXPECT_LE(error, other) << text << " became " << *value << ", but " << neighbour << " is nearer";
    if (error == other) {
      int exponent = 0;
      EXPECT_EQ(std::fmod(std::ldexp(std::frexp(*value, &exponent), 24), 2.0f), 0) << text;
    }
  }
}

TEST(ObjNumber, IsRoundedToTheNearestFloat) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string text = random() % 2 ? "-" : "";
    const std::size_t digits = 1 + random() % 24, point = random() % (digits + 1);
    for (std::size_t d = 0; d < digits; ++d) {
      if (d == point) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    const bool has_exponent = random() % 2 != 0;
    if (has_exponent) text.append("e").append(std::to_string(static_cast<int>(random() % 50) - 35));
    expect_nearest(text);
  }
}

TEST(ObjNumber, HalfwayCasesGoToEven) {
  EXPECT_EQ(parse_float("16777217"), 16777216.0f);                         // 2^24 + 1
  EXPECT_EQ(parse_float("16777219"), 16777220.0f);                         // 2^24 + 3
  EXPECT_EQ(parse_float("16777217.0000000000000000000001"), 16777218.0f);  // fp64 in between would lose the last digit
  EXPECT_EQ(parse_float("1.00000005960464477539062500"), 1.0f);            // 1 + 2^-24
  EXPECT_EQ(parse_float("1.00000005960464477539062501"), 1.0f + std::ldexp(1.0f, -23));
}

TEST(ObjNumber, SmallestAndLargest) {
  EXPECT_EQ(parse_float("1e-45"), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(parse_float("1e-46"), 0.0f);
  EXPECT_TRUE(std::signbit(*parse_float("-1e-400")));
  EXPECT_EQ(parse_float(std::string("0.").append(500, '0').append("1")), 0.0f);
  EXPECT_EQ(parse_float("1e-99999999999999999999"), 0.0f);
  EXPECT_EQ(parse_float("3.4028235e38"), std::numeric_limits<float>::max());
  EXPECT_FALSE(parse_float("3.5e38"));
  EXPECT_FALSE(parse_float(std::string("1").append(500, '0')));
  EXPECT_FALSE(parse_float("1e99999999999999999999"));
  EXPECT_FALSE(parse_float("-1e39"));
}

TEST(ObjNumber, WordsThatAreNone) {
  for (const char* word : {"", "+", "-", "+-1", ".", "1,5", "0x10", "nan", "inf", "-infinity", "1e", "1.5f", "1 2"})
    EXPECT_FALSE(parse_float(word)) << word;
  EXPECT_EQ(parse_float("+.5"), 0.5f);
  EXPECT_EQ(parse_float("5."), 5.0f);
  EXPECT_FALSE(parse_integer("1.0"));
  EXPECT_FALSE(parse_integer("9223372036854775808"));
  EXPECT_EQ(parse_integer("+7"), 7);
}

TEST(ObjStatements, LineEndsCommentsAndContinuations) {
  ObjStatements statements("# first\r\n\r\nv 1 2 \\\r\n 3 # tail\rf 1\\\n2\n\n  vn\t0\v1 # end\\\nlast");
  ASSERT_TRUE(statements.next());
  EXPECT_EQ(statements.keyword(), "v");
  EXPECT_EQ(statements.line(), 3u);
  EXPECT_EQ(statements.remainder(), "1 2   3");
  EXPECT_EQ(statements.word(), "1");
  EXPECT_EQ(statements.word(), "2");
  EXPECT_EQ(statements.word(), "3");
  EXPECT_EQ(statements.word(), "");
  ASSERT_TRUE(statements.next());
  EXPECT_EQ(statements.line(), 5u);
  EXPECT_EQ(statements.remainder(), "1 2");
  ASSERT_TRUE(statements.next());
  EXPECT_EQ(statements.keyword(), "vn");
  EXPECT_EQ(statements.line(), 8u);
  EXPECT_EQ(statements.remainder(), "0\v1");
  ASSERT_TRUE(statements.next()) << "a comment ends with its line";
  EXPECT_EQ(statements.keyword(), "last");
  EXPECT_FALSE(statements.next());
}

TEST(ObjStatements, CommentsStartALineOrFollowABlank) {
  ObjStatements statements("usemtl a#1 # b\\\n\t# c\\\nf 1 \\\n# d \\\nf 2#3\n#");
  ASSERT_TRUE(statements.next());
  EXPECT_EQ(statements.remainder(), "a#1");
  ASSERT_TRUE(statements.next());
  EXPECT_EQ(statements.line(), 3u);
  EXPECT_EQ(statements.remainder(), "1");
  ASSERT_TRUE(statements.next());
  EXPECT_EQ(statements.remainder(), "2#3");
  EXPECT_FALSE(statements.next());
}

TEST(ObjStatements, AByteOrderMarkIsSkipped) {
  ObjStatements statements("\xEF\xBB\xBFv 1");
  ASSERT_TRUE(statements.next());
  EXPECT_EQ(statements.keyword(), "v");
  EXPECT_FALSE(ObjStatements("\xEF\xBB\xBF").next());
}

}  // namespace
}  // namespace morphcl::test
