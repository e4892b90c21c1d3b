#include "demos/viewer/key_script.hpp"

#include <gtest/gtest.h>

#include <string>

#include "morphcl/error.hpp"

namespace morphcl::viewer {
namespace {

TEST(KeyScript, ReadsKeysAndCounts) {
  const std::vector<KeyPress> expected = {
      {Key::step_forward, 37}, {Key::orthographic, 1}, {Key::eye_up, 3}, {Key::export_frame, 1}};
  EXPECT_EQ(parse_key_script("k37,o,w3,e"), expected);
}

TEST(KeyScript, ReadsNamedKeysBlanksAndUpperCase) {
  const std::vector<KeyPress> expected = {
      {Key::orbit_left, 12}, {Key::play, 1}, {Key::step_forward, 2}, {Key::leave, 1}};
  EXPECT_EQ(parse_key_script(" left12 , Space,Q2,ESC "), expected);
}

TEST(KeyScript, TicksOfATurnAreWrittenWithItsKey) {
  EXPECT_EQ(parse_key_script("t120,k,T"),
            (std::vector<KeyPress>{{Key::tick, 120}, {Key::step_forward, 1}, {Key::tick, 1}}));
}

TEST(KeyScript, ReadsTheLargestCount) {
  EXPECT_EQ(parse_key_script("p1000000"), (std::vector<KeyPress>{{Key::step_back, kMaxPresses}}));
}

void expect_refused(const std::string& script, const std::string& part_of_message) {
  try {
    parse_key_script(script);
    ADD_FAILURE() << '"' << script.substr(0, 60) << "\" was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_EQ(error.place(), "--script");
    const std::string line = error.what();
    EXPECT_NE(line.find(part_of_message), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    EXPECT_LT(line.size(), 300u) << line;
  }
}

TEST(KeyScript, RefusesUnknownKeysAndNamesThePress) {
  expect_refused("x", "press 1 \"x\": starts with no key; keys are k p space o f w s");
  expect_refused("k3,p,kk2", "press 3 \"kk2\"");
  expect_refused("37", "press 1 \"37\": starts with no key");
}

TEST(KeyScript, RefusesEmptyPresses) {
  expect_refused("", "press 1 \"\"");
  expect_refused("k,,p", "press 2 \"\"");
  expect_refused("k,", "press 2 \"\"");
}

TEST(KeyScript, RefusesCountsThatAreNoCounts) {
  for (const char* script : {"k0", "k-1", "k+1", "k1.5", "k3x", "k 3", "k1000001", "k99999999999999999999"}) {
    expect_refused(script, "the count after the key must be a whole number from 1 to 1000000");
  }
}

TEST(KeyScript, RefusesTooManyPressesInAll) { expect_refused("k600000,p600000", "press 2"); }

TEST(KeyScript, RefusesHugeAndHostileText) {
  expect_refused(std::string(kMaxScriptLength + 1, 'k'), "has 65537 characters; at most 65536");
  expect_refused(std::string(kMaxScriptLength, 'k'), "press 1");
  expect_refused("k,\n\x1b[2J", "press 2");
  expect_refused("\xff\xfe", "press 1");
}

}  // namespace
}  // namespace morphcl::viewer
