// What people write who come from other programs: refused, with what to write instead.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/scene/model/rate_hint.hpp"
#include "host/scene/shot/color_hint.hpp"
#include "host/scene/shot/key_hint.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

std::string refusal_of(const std::string& shot) {
  const test::ShotFolder folder;
  return folder.refusal(shot + "\n" + std::string(test::cube_object));
}

std::string unknown_key(const std::string& table, const std::string& key) {
  const std::string error = refusal_of("[" + table + "]\n" + key + " = 1");
  const std::string expected = "shot.toml:2:1: unknown key \"" + key + "\" in " + table + "; ";
  EXPECT_EQ(error.substr(0, expected.size()), expected);
  return error.substr(std::min(error.size(), expected.size()));
}

TEST(ShotHint, CameraKeysOfOtherPrograms) {
  for (const char* key : {"position", "from", "look_from", "lookFrom", "origin", "Eye"})
    EXPECT_EQ(unknown_key("camera", key), "did you mean \"eye\"?") << key;
  for (const char* key : {"look_at", "lookat", "lookAt", "look-at", "at", "to", "center"})
    EXPECT_EQ(unknown_key("camera", key), "did you mean \"target\"?") << key;
  for (const char* key : {"fov", "fovy", "fov_degrees", "yfov", "field_of_view", "fovy_radians", "fovy_deg"})
    EXPECT_EQ(unknown_key("camera", key),
              "did you mean \"fovy_degrees\"? (in degrees, from bottom to top; fovx_degrees is across)")
        << key;
  EXPECT_EQ(unknown_key("camera", "hfov"),
            "did you mean \"fovx_degrees\"? (in degrees, from left to right; fovy_degrees is upwards)");
  EXPECT_EQ(unknown_key("camera", "azimuth"), "did you mean \"azimuth_degrees\"?");
  EXPECT_EQ(unknown_key("camera", "znear"), "did you mean \"near\"?");
}

TEST(ShotHint, CameraErrorsListEyeAndTargetFirst) {
  EXPECT_EQ(unknown_key("camera", "whatsoever").substr(0, 24), "known: eye, target, up, ");
}

TEST(ShotHint, KeysOfOtherTables) {
  EXPECT_EQ(unknown_key("image", "resolution"), "did you mean \"size\"?");
  EXPECT_EQ(unknown_key("frames", "frame_rate"), "did you mean \"fps\"?");
  EXPECT_EQ(unknown_key("frames", "start"), "did you mean \"range\"?");
  EXPECT_EQ(refusal_of("[[lights]]\ndirection = [0, 0, 1]"),
            "shot.toml:1:3: unknown key \"lights\" in a shot; did you mean \"light\"?");
  EXPECT_EQ(refusal_of("[[light]]\ndirection = [0, 0, 1]\nstrength = 2"),
            "shot.toml:3:1: unknown key \"strength\" in light; did you mean \"intensity\"?");
}

// A key that another table has under this name, or that this one has itself, is not led astray.
TEST(ShotHint, OnlyKnownKeysAreNamed) {
  EXPECT_EQ(key_hint("position", {"direction", "color"}), "; known: direction, color");
  EXPECT_EQ(key_hint("to", {"from", "degrees"}), "; known: from, degrees");
  EXPECT_EQ(key_hint("colour", {"color", "mesh"}), "; did you mean \"color\"?");
  EXPECT_EQ(key_hint("rotate", {"translate", "rotate_about_axis"}), "; did you mean \"rotate_about_axis\"?");
  EXPECT_EQ(key_hint("", {}), "");
}

TEST(ShotHint, TextWithoutQuotes) {
  const test::ShotFolder folder;
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = cube"), "shot.toml:2:8: the text cube needs quotes: \"cube\"");
  EXPECT_EQ(folder.refusal("[[object]]\r\nmesh = models/pot.obj # a pot\r\n"),
            "shot.toml:2:8: the text models/pot.obj needs quotes: \"models/pot.obj\"");
  EXPECT_EQ(folder.refusal("[image]\nchannels = [\"Z\", RGBA]"),
            "shot.toml:2:18: the text RGBA needs quotes: \"RGBA\"");
  EXPECT_EQ(folder.refusal("[[object.track]]\nkeys = [{ frame = 0, value = linear }]"),
            "shot.toml:2:30: the text linear needs quotes: \"linear\"");
}

TEST(ShotHint, WordsThatAreNoText) {
  const test::ShotFolder folder;
  EXPECT_EQ(folder.refusal("[[object]]\ndouble_sided = True"),
            "shot.toml:2:16: True is written in small letters: true");
  EXPECT_EQ(folder.refusal("[camera]\nnear = .5").find("needs quotes"), std::string::npos) << "a number";
  EXPECT_EQ(folder.refusal("[camera]\nnear = 1 2").find("needs quotes"), std::string::npos);
}

TEST(ShotHint, BackslashesInPaths) {
  const test::ShotFolder folder;
  const std::string error = folder.refusal("[[object]]\nmesh = \"models\\pot.obj\"");
  EXPECT_EQ(error.substr(0, 12), "shot.toml:2:");
  EXPECT_NE(error.find("; in double quotes a backslash begins an escape: write / in paths, or \\\\"), std::string::npos)
      << error;
}

TEST(ShotHint, PathsOfWindows) {
  const test::ShotFolder folder;
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = 'models\\pot.obj'"),
            "cannot read: shot.toml:2:8: there is no file \"models\\pot.obj\"; folders are separated by /");
  const std::string error = folder.refusal("[[object]]\nmesh = \"models\\tree.obj\"");
  EXPECT_NE(error.find("in double quotes a backslash begins an escape"), std::string::npos) << error;
}

TEST(ShotHint, DecimalRates) {
  EXPECT_EQ(refusal_of("[frames]\nfps = 29.97"),
            "shot.toml:2:7: fps is 29.97; a rate is an integer or a ratio of two, exactly: fps = [30000, 1001]");
  EXPECT_EQ(refusal_of("[frames]\nfps = \"25\""),
            "shot.toml:2:7: fps is \"25\"; a rate is an integer or a ratio of two, exactly: fps = 25");
  const auto text = [](double rate) {
    const auto exact = exact_rate(rate);
    return exact ? std::to_string(exact->fps_numerator) + "/" + std::to_string(exact->fps_denominator) : "none";
  };
  EXPECT_EQ(text(23.976), "24000/1001");
  EXPECT_EQ(text(23.98), "24000/1001");
  EXPECT_EQ(text(59.94), "60000/1001");
  EXPECT_EQ(text(119.88), "120000/1001");
  EXPECT_EQ(text(24), "24/1");
  EXPECT_EQ(text(12.5), "25/2");
  EXPECT_EQ(text(0), "none");
  EXPECT_EQ(text(-25), "none");
  EXPECT_EQ(text(std::nan("")), "none");
  EXPECT_EQ(rate_in_text("30000/1001")->fps_denominator, 1001);
  EXPECT_FALSE(rate_in_text("25/0"));
  EXPECT_FALSE(rate_in_text("fast"));
  EXPECT_FALSE(rate_in_text("25 "));
}

TEST(ShotHint, SizesOfTheCommandLine) {
  EXPECT_EQ(refusal_of("[image]\nsize = \"1920x1080\""),
            "shot.toml:2:8: size is \"1920x1080\"; in a shot it is two integers: size = [1920, 1080]");
  EXPECT_EQ(refusal_of("[image]\nsize = \"1920\""),
            "shot.toml:2:8: size must be two integers: [width, height] in pixels");
}

TEST(ShotHint, ColoursOfOtherPrograms) {
  const std::string ambient = "ambient = ";
  EXPECT_EQ(refusal_of(ambient + "\"#ff8800\""),
            "shot.toml:1:11: ambient is \"#ff8800\"; colours are three numbers, linear light: [1, 0.2462, 0]");
  EXPECT_EQ(refusal_of(ambient + "[255, 136, 0]"),
            "shot.toml:1:12: ambient holds 255; colours are linear light, 1 is white: sRGB [255, 136, 0] of 255 is "
            "[1, 0.2462, 0]; write 255.0 if it is meant");
  const test::ShotFolder folder;
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"cube\"\ncolor = [10, 136, 0, 1]"),
            "shot.toml:3:14: color holds 136; colours are linear light, 1 is white: sRGB [10, 136, 0, 1] of 255 is "
            "[0.003035, 0.2462, 0, 0.003922]; write 136.0 if it is meant");
  EXPECT_EQ(refusal_of("[[light]]\ndirection = [0, 0, 1]\ncolor = [255, 255, 255]").substr(0, 30),
            "shot.toml:3:10: color holds 25");
  const std::string background = "[image]\nbackground = ";
  EXPECT_EQ(refusal_of(background + "\"#f80\"").substr(0, 38), "shot.toml:2:14: background is \"#f80\"; ");
  EXPECT_EQ(refusal_of(background + "[255, 136, 0]").substr(0, 36), "shot.toml:2:15: background holds 255");
  EXPECT_EQ(refusal_of(background + "[\"#f80\", \"#000\"]").substr(0, 38), "shot.toml:2:15: background is \"#f80\"; ");
  EXPECT_EQ(refusal_of(background + "[[0, 0, 0], [0, 0, 64]]").substr(0, 35), "shot.toml:2:33: background holds 64");
  EXPECT_EQ(linear_of_hex("#f80"), "[1, 0.2462, 0]");
  EXPECT_EQ(linear_of_hex("000000"), "[0, 0, 0]");
  EXPECT_EQ(linear_of_hex("#00000080"), "[0, 0, 0, 0.502]");
  for (const char* other : {"", "#", "red", "#ff88", "#gg8800", "#ff8800f", "#-1-1-1"})
    EXPECT_EQ(linear_of_hex(other).value_or("none").substr(0, 1), std::string(other) == "#ff88" ? "[" : "n") << other;
}

TEST(ShotHint, BrightLightIsNoMistake) {
  const test::ShotFolder folder;
  const std::string object(test::cube_object);
  EXPECT_NO_THROW(folder.load("[[light]]\nposition = [0, 0, 9]\nfalloff = true\ncolor = [200, 200, 255]\n" + object));
  EXPECT_NO_THROW(folder.load("[[light]]\ndirection = [0, 0, 9]\ncolor = [20.0, 20.0, 20.0]\n" + object));
  EXPECT_NO_THROW(folder.load("[[light]]\ndirection = [0, 0, 9]\ncolor = [2, 2, 2]\n" + object));
}

// Editors of other systems: a mark at the beginning, ends of lines, tabs.
TEST(ShotHint, MarksTabsAndEndsOfLinesOfOtherSystemsAreFine) {
  const test::ShotFolder folder;
  EXPECT_NO_THROW(folder.load("\xEF\xBB\xBF[frames]\r\n\tfps\t=\t24\t# film\r\n[[object]]\r\n\tmesh = 'cube'\r\n"));
}

TEST(ShotHint, Utf16IsNamed) {
  const test::ShotFolder folder;
  const std::string shot = "[[object]]\nmesh = 'cube'\n";
  std::string little = "\xFF\xFE", big = "\xFE\xFF", bare;
  for (const char c : shot) {
    little += {c, '\0'};
    big += {'\0', c};
    bare += {c, '\0'};
  }
  for (const std::string& text : {little, big, bare})
    EXPECT_EQ(folder.refusal(text), "shot.toml: is text in UTF-16; save it as UTF-8, which is read");
}

}  // namespace
}  // namespace morphcl
