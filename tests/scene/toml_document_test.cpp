// Hostile and damaged shot files: refused with one line, never a crash or a hang.
#include "host/scene/shot/toml_document.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "host/scene/shot/shot_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {
namespace {

std::string toml_refusal(const std::string& text) {
  try {
    parse_toml(text, "file");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "accepted";
}

std::string repeated(const std::string& piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

TEST(TomlDocument, KnowsThePlaceOfEveryValue) {
  const TomlValue root = parse_toml("a = 1\n[b]\n  c = [1,\n 2.5]\n", "file");
  const auto& table = std::get<TomlValue::Table>(root.data);
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[0].key, "a");
  EXPECT_EQ(table[0].value.column, 5);
  const TomlEntry& c = std::get<TomlValue::Table>(table[1].value.data)[0];
  EXPECT_EQ(c.line, 3);
  EXPECT_EQ(c.column, 3);
  const TomlValue& number = std::get<TomlValue::Array>(c.value.data)[1];
  EXPECT_EQ(number.line, 4);
  EXPECT_EQ(number.column, 2);
  EXPECT_EQ(std::get<double>(number.data), 2.5);
}

// The library looks whether such a letter ends a value, by a function that is undefined for most of them.
TEST(TomlDocument, LettersOutsideAsciiAreRefusedWithTheirPlaceOrRead) {
  EXPECT_EQ(toml_refusal("a = [ä]").substr(0, 9), "file:1:6:");
  EXPECT_EQ(toml_refusal("b = 1\na = ä").substr(0, 9), "file:2:5:");
  EXPECT_EQ(toml_refusal("a = 1ä").substr(0, 9), "file:1:6:");
  EXPECT_EQ(toml_refusal("ä = 1").substr(0, 9), "file:1:1:");
  EXPECT_EQ(toml_refusal("a = { ж = 1 }").substr(0, 7), "file:1:");
  EXPECT_EQ(toml_refusal("a = true漢").substr(0, 7), "file:1:");
  EXPECT_EQ(toml_refusal("a = \"\"\"\\ä\"\"\"").substr(0, 7), "file:1:");
  for (const char* text : {"a = \"ä\" # ж", "a = \"\"\"\\\n  ä\"\"\"", "a = '''\nä'''"}) {
    const TomlValue root = parse_toml(text, "file");
    EXPECT_EQ(std::get<std::string>(std::get<TomlValue::Table>(root.data)[0].value.data), "ä") << text;
  }
  // Every letter of the lower blocks and some of all others, where the function is asked.
  for (unsigned c = 0x80; c < 0x10000; c += c < 0x500 ? 1 : 61) {
    if (c >= 0xd800 && c < 0xe000) continue;
    std::string letter;
    if (c < 0x800) {
      letter = {static_cast<char>(0xc0 | c >> 6), static_cast<char>(0x80 | (c & 0x3f))};
    } else {
      letter = {static_cast<char>(0xe0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3f)),
                static_cast<char>(0x80 | (c & 0x3f))};
    }
    EXPECT_NE(toml_refusal("a = [" + letter + "x]"), "accepted") << c;
    EXPECT_NE(toml_refusal("a = 1" + letter + "x"), "accepted") << c;
  }
}

TEST(TomlDocument, RefusesDeepNesting) {
  EXPECT_NE(toml_refusal(std::string("a = ") + repeated("[", 100) + repeated("]", 100)).find("nested deeper than 64"),
            std::string::npos);
  EXPECT_NE(toml_refusal(std::string("a = ") + repeated("[", 1'000'000)), "accepted");
  EXPECT_NE(toml_refusal(std::string("a = ") + repeated("{ a = ", 1'000'000)), "accepted");
  EXPECT_NE(toml_refusal(std::string("a = ") + repeated("{ a.b.c.d.e.f.g.h = ", 250) + "1" + repeated("}", 250)),
            "accepted");
}

TEST(TomlDocument, RefusesLongDottedKeys) {
  EXPECT_EQ(toml_refusal(std::string("[") + repeated("a.", 1'000'000) + "a]"), "file:1:17: a key of more than 8 parts");
  EXPECT_EQ(toml_refusal(std::string("x = 1\n") + repeated("\"a\" . ", 1'000'000) + "a = 1"),
            "file:2:47: a key of more than 8 parts");
  EXPECT_EQ(toml_refusal(std::string("x = { ") + repeated("'a'.", 9) + "a = 1 }"),
            "file:1:38: a key of more than 8 parts");
}

TEST(TomlDocument, CountsNoDotsInStringsCommentsAndNumbers) {
  const std::string dots = "1.2.3.4.5.6.7.8.9.10.11";
  EXPECT_EQ(toml_refusal("a = \"" + dots + "\" # " + dots + "\nb = '" + dots + "'\nc = \"\"\"\\\"\"\" " + dots + "\n" +
                         dots + "\"\"\"\nd = [1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5]\ne = \"\\\\\"\nf = 1.5\n"),
            "accepted");
}

TEST(TomlDocument, RefusesWhatIsTooLarge) {
  const std::string huge(max_toml_bytes + 1, '#');
  EXPECT_EQ(toml_refusal(huge), "file: 8388609 bytes of TOML; at most 8388608 are read");
}

TEST(TomlDocument, RefusesBytesThatAreNoText) {
  EXPECT_NE(toml_refusal("a = \"\xff\xfe\""), "accepted");
  EXPECT_NE(toml_refusal(std::string("a = 1\0b = 2", 11)), "accepted");
  EXPECT_NE(toml_refusal("a = \"one\x1b[31m\""), "accepted");
  EXPECT_NE(toml_refusal("a = 'open\n"), "accepted");
  EXPECT_NE(toml_refusal("a = '''open\n"), "accepted");
  EXPECT_NE(toml_refusal("a = \"open\\"), "accepted");
}

constexpr std::string_view shot = R"([image]
size = [64, 36]
[frames]
range = "0-10"
[camera]
eye = [3.0, 2.4, 5.1]
[[light]]
direction = [0.4, 0.7, 0.9]
[[object]]
mesh = "pyramid_to_cube"
[[object.transform]]
scale_about = { point = [100, 100, 30], factor = [0.01, 0.01, 0.01] }
[[object.track]]
target = "rotation"
keys = [[0, { axis = [1, 0, 1], degrees = 0 }], [10, [0, 0, 0, 1]]]
)";

// "" when the shot is read.
std::string shot_refusal(std::string_view text) {
  try {
    validate(read_shot_text(text, "shot.toml", {}));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
    return error.what();
  }
  return "";
}

TEST(DamagedShot, CutAnywhereIsReadOrRefused) {
  int refused = 0;
  for (std::size_t length = 0; length < shot.size(); ++length)
    if (!shot_refusal(shot.substr(0, length)).empty()) ++refused;
  EXPECT_GT(refused, 200);
  EXPECT_EQ(shot_refusal(shot), "");
}

TEST(DamagedShot, WithAnyBytesChangedIsReadOrRefused) {
  std::mt19937 random(11);
  const std::string_view bytes = "[]{}=.,\"'#\n\\ 0123456789-+eabnif\xc3";
  for (int round = 0; round < 10'000; ++round) {
    std::string damaged(shot);
    for (int change = 0; change <= round % 3; ++change)
      damaged[random() % damaged.size()] = bytes[random() % bytes.size()];
    const std::string line = shot_refusal(damaged);
    EXPECT_TRUE(line.empty() || line.substr(0, 10) == "shot.toml:") << line << "\n" << damaged;
  }
}

}  // namespace
}  // namespace morphcl
