// What the progress bar says in terminals of every width.
#include "cli/progress_line.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace morphcl::cli {
namespace {

using Phase = ProgressState::Phase;

const ProgressState drawing{Phase::drawing, 12, 101, 0, 3.24, 27.4};
const ProgressState checking{Phase::checking, 1200, 5000};
const ProgressState compiling{Phase::compiling, 0, 101, 5};

TEST(ProgressLine, SaysAllThatFits) {
  EXPECT_EQ(progress_line(drawing, 120, false),
            "[###...........................] 12/101 frames  3.2 frames/s  00:27 left");
  EXPECT_EQ(progress_line(drawing, 60, false), "[##...............] 12/101 frames  3.2 frames/s  00:27 left");
  EXPECT_EQ(progress_line(drawing, 50, false), "12/101 frames  3.2 frames/s  00:27 left");
  EXPECT_EQ(progress_line(drawing, 40, false), "12/101 frames  3.2 frames/s  00:27 left");
  EXPECT_EQ(progress_line(drawing, 39, false), "[#.........] 12/101 frames  00:27 left");
  EXPECT_EQ(progress_line(drawing, 24, false), "12/101  00:27 left");
  EXPECT_EQ(progress_line(drawing, 20, false), "12/101  00:27 left");
  EXPECT_EQ(progress_line(drawing, 18, false), "12/101  00:27");
  EXPECT_EQ(progress_line(drawing, 10, false), "12/101");
}

TEST(ProgressLine, SaysThatKernelsAreCompiledAndFramesChecked) {
  EXPECT_EQ(
      progress_line(compiling, 120, false),
      "[..............................] 0/101 frames  compiling kernels, 5 so far; the first frame waits for them");
  EXPECT_EQ(progress_line(compiling, 50, false), "0/101 frames  compiling kernels, 5 so far");
  EXPECT_EQ(progress_line(compiling, 20, false), "compiling kernels");
  EXPECT_EQ(progress_line(checking, 90, false),
            "[#######.......................] 1200/5000 frames, checking what is finished");
  EXPECT_EQ(progress_line(checking, 20, false), "checking 1200/5000");
}

TEST(ProgressLine, BeforeAFrameIsWrittenItNamesNoSpeed) {
  EXPECT_EQ(progress_line({Phase::drawing, 0, 101}, 80, false), "[..............................] 0/101 frames");
}

TEST(ProgressLine, SlowFramesAreSecondsEach) {
  EXPECT_EQ(progress_line({Phase::drawing, 1, 9, 0, 0.4, 20}, 45, false), "1/9 frames  2.5 s/frame  00:20 left");
}

// The time goes to hours, and no further than two digits of them.
TEST(ProgressLine, LongTimesAreHours) {
  EXPECT_EQ(progress_line({Phase::drawing, 1, 101, 0, 0.01, 9000}, 30, false), "1/101 frames  02:30:00 left");
  EXPECT_EQ(progress_line({Phase::drawing, 1, 101, 0, 1e-9, 1e12}, 30, false), "1/101 frames  99:59:59 left");
}

std::string without_escapes(const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\033')
      i = line.find('m', i);
    else
      text += line[i];
  }
  return text;
}

TEST(ProgressLine, NeverReachesTheLastColumnAtAnyWidth) {
  const std::vector<ProgressState> states{
      drawing,
      checking,
      compiling,
      {Phase::drawing, 0, 1},
      {Phase::drawing, 2'000'000, 2'000'000, 0, 123'456.7, 359'999},
      {Phase::checking, 1'999'999, 2'000'000},
      {Phase::compiling, 0, 2'000'000, 100},
      {Phase::drawing, 7, 5, 0, 1, 0},  // more than all
  };
  for (const ProgressState& state : states)
    for (int columns = 1; columns <= 200; ++columns) {
      const std::string plain = progress_line(state, columns, false);
      EXPECT_LT(plain.size(), static_cast<std::size_t>(columns)) << plain;
      EXPECT_EQ(without_escapes(progress_line(state, columns, true)), plain);
      if (columns >= 20) {
        EXPECT_FALSE(plain.empty()) << columns;
      }
    }
}

// A wider terminal never says less.
TEST(ProgressLine, WordsComeBackWithTheWidth) {
  const auto words = [](int columns) {
    const std::string line = progress_line(drawing, columns, false);
    return line.starts_with('[') ? line.substr(line.find("] ") + 2) : line;
  };
  for (int columns = 8; columns < 120; ++columns)
    EXPECT_LE(words(columns).size(), words(columns + 1).size()) << columns;
}

}  // namespace
}  // namespace morphcl::cli
