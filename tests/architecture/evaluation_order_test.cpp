// No value depends on which argument or operand a compiler evaluates first.
#include "tests/architecture/evaluation_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morphcl::architecture {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(EvaluationOrder, NoValueOfTheLibraryOrTheToolDependsOnIt) {
  const std::vector<std::string> folders = {"include", "host", "anim", "lab", "cli", "demos"};
  EXPECT_THAT(unordered_calls_below(MORPHCL_SOURCE_DIR, folders, folders), IsEmpty());
}

// Bounds and hashes of a test hold for the numbers that it draws.
TEST(EvaluationOrder, NoRandomNumbersOfATestDependOnIt) {
  EXPECT_THAT(unordered_calls_below(MORPHCL_SOURCE_DIR, {"tests", "bench"}, {"tests/support/random.hpp"}), IsEmpty());
}

const std::string dice = R"(class Dice {
 public:
  int next() { return ++state_; }
  int in(int low, int high);
  int sum() const;
  void reset();
  int pair() { %; }
};
)";

std::vector<std::string> found(const std::string& code) { return unordered_calls("x", dice + code, {}); }

std::vector<std::string> found_in_member(const std::string& code) {
  std::string text = dice;
  return unordered_calls("x", text.replace(text.find('%'), 1, code), {});
}

TEST(EvaluationOrder, MembersThatChangeTheirObjectAreKnown) {
  EXPECT_THAT(changing_members({dice}), ElementsAre("in", "next", "pair"));
  EXPECT_THAT(changing_members({dice, "struct Range {\n  bool in(int value) const { return value > 0; }\n};\n"}),
              ElementsAre("next", "pair"));
}

TEST(EvaluationOrder, IsOpenBetweenArgumentsAndOperands) {
  EXPECT_THAT(found("int a = f(dice.next(), dice.next());"), ElementsAre("x:9: dice.next and dice.next"));
  EXPECT_THAT(found("int a = f(g(dice.next()), 1 + dice.in(1, 2));"), ElementsAre("x:9: dice.next and dice.in"));
  EXPECT_THAT(found("int a = dice->next() - dice->next();"), ElementsAre("x:9: dice.next and dice.next"));
  EXPECT_THAT(found_in_member("return f(next(), in(1, 2))"), ElementsAre("x:7: this.next and this.in"));
  EXPECT_THAT(found("auto two = [&] { return dice.next(); };\nint a = f(two(), two());"),
              ElementsAre("x:10: two and two"));
}

TEST(EvaluationOrder, IsOpenBetweenRandomNumbers) {
  const std::string engine =
      "std::mt19937 engine(1);\nstd::uniform_real_distribution<float> unit(-1, 1), half{0, 0.5};\n";
  EXPECT_THAT(found(engine + "f(engine(), engine());"), ElementsAre("x:11: engine and engine"));
  EXPECT_THAT(found(engine + "glm::vec2 a(unit(engine), half(engine));"), ElementsAre("x:11: unit and half"));
  EXPECT_THAT(found(engine + "const auto size = [&] { return 2 * half(engine); };\nf(size(), unit(engine));"),
              ElementsAre("x:12: size and unit"));
  EXPECT_THAT(found("float f(std::mt19937_64& random) { return g(random(), random()); }"),
              ElementsAre("x:9: random and random"));
  EXPECT_THAT(found(engine + "glm::vec2 a{unit(engine), half(engine)};"), IsEmpty());
  EXPECT_THAT(found(engine + "const float y = unit(engine), x = half(engine);"), IsEmpty());
  EXPECT_THAT(found("say(R\"(a)\");\nf(dice.next(), dice.next());"), ElementsAre("x:10: dice.next and dice.next"));
}

TEST(EvaluationOrder, IsGivenBySomeOperatorsAndByBraces) {
  for (const std::string code :
       {"int a = f(dice.next(), other.next());", "int a = f(dice.sum(), dice.sum());",
        "int a = dice.next(), b = dice.next();", "std::array<int, 2> a{dice.next(), dice.next()};",
        "bool a = dice.next() && dice.next();", "int a = dice.next() ? dice.next() : dice.next();",
        "out << dice.next() << dice.next();", "a = dice.next();\nb = dice.next();", "int a = dice.in(0, dice.next());",
        "// f(dice.next(), dice.next())", "say(\"f(dice.next(), dice.next())\");"})
    EXPECT_THAT(found(code), IsEmpty()) << code;
}

}  // namespace
}  // namespace morphcl::architecture
