// What an .obj file says about looks alone: wrong or missing, it costs a warning and never the model.
#include <gtest/gtest.h>

#include "host/scene/obj/obj_import.hpp"
#include "morphcl/mesh.hpp"
#include "tests/scene/import_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

const std::string plate = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string red_plate = plate + "usemtl red\nf 1 2 3 4\n";

class ObjLooks : public testing::Test {
 protected:
  ImportedModel model(const std::string& text) { return import_obj(folder.write("model.obj", text)); }
  Material material(const std::string& text) {
    const ImportedModel read = model(text);
    return read.objects.empty() ? Material{} : read.objects[0].material;
  }
  // The model is read with one warning, which holds `words`; none when they are empty.
  void expect_warning(const std::string& text, const std::string& words) {
    const ImportedModel read = model(text);
    ASSERT_EQ(read.warnings.size(), words.empty() ? 0u : 1u) << text;
    if (!words.empty()) {
      EXPECT_NE(read.warnings[0].find(words), std::string::npos) << read.warnings[0];
    }
  }
  test_support::TemporaryFolder folder;
};

const glm::dvec4 red(1, 0, 0, 1);

TEST_F(ObjLooks, NormalsThatAreWrongLightTheFacesFlat) {
  const std::string corners = "f 1//1 2//2 3//1 4//1\n";
  for (const std::string normals :
       {"vn 0 0 1\n", "vn 0 0 1\nvn 0 0 0\n", "vn 0 0 1\nvn nan 0 1\n", "vn 0 0 1\nvn 0 0\n",
        "vn 0 0 1\nvn -1.#IND -1.#IND -1.#IND\n", "vn 0 0 1\nvn 1e39 0 0\n"}) {
    const ImportedModel read = model(plate + normals + corners);
    EXPECT_TRUE(read.meshes[0].normals.empty()) << normals;
    EXPECT_EQ(read.meshes[0].positions.size(), 4u) << normals;
    expect_warning(plate + normals + corners, "the normals of 1 of 4 face corners are missing, zero or no numbers");
  }
  expect_warning(plate + "f 1//1 2//0 3//-1 4//99999999999\n", "the normals of 4 of 4 face corners");
  expect_warning(plate + "vn 0 0 1\nvn nan nan nan\nf 1//1 2//1 3//1 4//1\n", "");
}

TEST_F(ObjLooks, EmptyIndicesAreAbsent) {
  for (const std::string face : {"f 1// 2// 3// 4//", "f 1/ 2/ 3/ 4/", "f 1/1/ 2/1/ 3/1/ 4/1/"}) {
    const ImportedModel read = model(plate + "vt 0 0\n" + face);
    EXPECT_EQ(read.meshes[0].triangles.size(), 2u) << face;
    EXPECT_TRUE(read.warnings.empty()) << face;
  }
}

TEST_F(ObjLooks, SmallFacesAreLeftOut) {
  expect_warning(plate + "f 1 2\nf\nf 1 2 3 4\nf 1\n",
                 "3 faces of fewer than 3 corners are not drawn, the first at line 5");
  EXPECT_EQ(model(plate + "f 1 2\nf 1 2 3 4\n").meshes[0].triangles.size(), 2u);
  EXPECT_TRUE(model(plate + "f 1 2\n").objects.empty());
}

TEST_F(ObjLooks, ColorsBeyondTheirRange) {
  const std::string faces = "f 1 2 3\n";
  expect_warning("v 0 0 0 1.00002 0 0\nv 1 0 0 1 0 0\nv 0 1 0 -0.1 0 0\n" + faces,
                 "2 of 3 vertices are not from 0 to 1");
  const std::string bytes = "v 0 0 0 255 0 51\nv 1 0 0 255 0 51\nv 0 1 0 255 0 51\n" + faces;
  expect_warning(bytes, "vertex colours are taken as 0 to 255");
  EXPECT_EQ(model(bytes).meshes[0].colors[0], glm::vec4(1, 0, 0.2f, 1));
  const std::string none = "v 0 0 0 nan 0 0\nv 1 0 0 0 x 0\nv 0 1 0 0 0 1e39\n" + faces;
  expect_warning(none, "vertex colours are no numbers; the default colour is used");
  EXPECT_TRUE(model(none).meshes[0].colors.empty());
  EXPECT_EQ(material(none).base_color, Material{}.base_color);
}

TEST_F(ObjLooks, SevenNumbersAreAWeightOrEndInAlpha) {
  const auto vertices = [](const std::string& a, const std::string& b) {
    return "v 0 0 0 " + a + "\nv 1 0 0 " + b + "\nv 0 1 0 " + a + "\nf 1 2 3\n";
  };
  EXPECT_EQ(model(vertices("1 0.5 0.25 0", "1 0 0 1")).meshes[0].colors[0], glm::vec4(0.5f, 0.25f, 0, 1));
  expect_warning(vertices("1 0.5 0.25 0", "1 0 0 1"), "");
  EXPECT_EQ(model(vertices("0.5 0.25 0 1", "1 0 0 1")).meshes[0].colors[0], glm::vec4(0.5f, 0.25f, 0, 1));
  expect_warning(vertices("0.5 0.25 0 1", "1 0 0 1"), "the fourth is taken for red");
  EXPECT_EQ(model(vertices("1 0 0 1", "1 0 0 1")).meshes[0].colors[0], glm::vec4(0, 0, 1, 1));
  expect_warning(vertices("1 0 0 1", "1 0 0 1"), "the fourth is taken for a weight, not for red");
}

TEST_F(ObjLooks, WhiteVerticesAreWhite) {
  EXPECT_EQ(material("v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n").base_color, glm::dvec4(1.0));
  folder.write("red.mtl", "newmtl red\nKd 1 0 0\n");
  EXPECT_EQ(material("mtllib red.mtl\nv 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nusemtl red\nf 1 2 3\n").base_color,
            red);
}

TEST_F(ObjLooks, LibrariesAreFoundBesideTheModel) {
  folder.write("red.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("my red.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("blue.mtl", "newmtl blue\nKd 0 0 1\n");
  folder.write("red#1.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("sub/deep.mtl", "newmtl red\nKd 1 0 0\n");
  for (const std::string library : {"red.mtl", "my red.mtl", "red#1.mtl", "blue.mtl red.mtl", "my red.mtl blue.mtl",
                                    ".\\red.mtl", "sub\\deep.mtl", "sub/deep.mtl", "gone/red.mtl"}) {
    EXPECT_EQ(material("mtllib " + library + "\n" + red_plate).base_color, red) << library;
    expect_warning("mtllib " + library + "\n" + red_plate, "");
  }
  for (const std::string library : {"/data/props/red.mtl", "C:\\props\\red.mtl", "../red.mtl", "..\\red.mtl"}) {
    EXPECT_EQ(material("mtllib " + library + "\n" + red_plate).base_color, red) << library;
    expect_warning("mtllib " + library + "\n" + red_plate,
                   library == "..\\red.mtl" ? "" : "red.mtl beside the model is used");
  }
  for (const std::string library : {"none.mtl", "/etc/none.mtl", "../none.mtl"}) {
    EXPECT_EQ(material("mtllib " + library + "\n" + red_plate).base_color, Material{}.base_color) << library;
    expect_warning("mtllib " + library + "\n" + red_plate, "the default colour is used");
  }
  expect_warning("mtllib blue.mtl\n" + red_plate, "no material library holds red");
}

TEST_F(ObjLooks, MaterialValuesBeyondTheirRange) {
  const auto with = [&](const std::string& lines) {
    folder.write("red.mtl", "newmtl red\n" + lines);
    return "mtllib red.mtl\n" + red_plate;
  };
  EXPECT_EQ(material(with("Kd 1.5 -0.1 0\n")).base_color, red);
  expect_warning(with("Kd 1.00001 0 0\n"),
                 "red.mtl:2: '1.00001' is not a part of a colour, from 0 to 1, and is clamped");
  for (const std::string broken : {"nan 0 0", "0,8 0,8 0,8", "", "1e39 0 0"}) {
    EXPECT_EQ(material(with("Kd " + broken + "\n")).base_color, Material{}.base_color) << broken;
    expect_warning(with("Kd " + broken + "\n"), "the default colour is used");
  }
  expect_warning(with("Kd 1 0 0\nKe 1 1 1\nmap_Kd a.png\nd 0.5\n"), "not drawn: emission, textures");
  EXPECT_EQ(material(with("Kd 1 0 0\nd 0.5\n")).base_color, glm::dvec4(1, 0, 0, 0.5));
  EXPECT_EQ(material(with("Kd 1 0 0\nTr 0.25\n")).base_color, glm::dvec4(1, 0, 0, 0.75));
  EXPECT_EQ(material(with("d 0.5\n")).base_color, glm::dvec4(0.8, 0.8, 0.8, 0.5));
  expect_warning(with("Kd 1 0 0\nKe 0 0 0\nd 1\nTr 1\n"), "");
  for (const std::string gone : {"d 0.0", "d -halo 0", "Tr 1"}) {
    expect_warning(with(gone + "\n"), "alpha is 0 (d 0 or Tr 1), so nothing is drawn of red");
    EXPECT_TRUE(model(with(gone + "\n")).objects.empty()) << gone;
  }
  expect_warning(with("d y\n"), "'y' is not a number from 0 to 1; 1 is used");
}

TEST_F(ObjLooks, TargetsMayHoldPositionsAlone) {
  const std::string neutral = folder.write("neutral.obj", plate + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n");
  const std::string high = folder.write("high.obj", "v 0 0 5\nv 1 0 6\nv 1 1 7\nv 0 1 8\n");
  const ImportedModel read = import_obj_targets(neutral, {high});
  ASSERT_EQ(read.meshes.size(), 2u);
  EXPECT_EQ(read.meshes[0].targets[0].positions, (std::vector<glm::vec3>{{0, 0, 5}, {1, 0, 6}, {1, 1, 7}}));
  EXPECT_EQ(read.meshes[1].targets[0].positions, (std::vector<glm::vec3>{{0, 0, 5}, {1, 1, 7}, {0, 1, 8}}));
  EXPECT_EQ(read.objects[1].name, "neutral.b");
  const std::string few = folder.write("few.obj", "v 0 0 5\n");
  expect_refusal([&] { import_obj_targets(neutral, {few}); }, ErrorKind::bad_input, few, "has 1 vertices (v)");
}

TEST_F(ObjLooks, NothingToDrawIsNoError) {
  EXPECT_TRUE(model(plate + "l 1 2 3\n").objects.empty());
  expect_warning(plate + "p 1 2 3\n", "not drawn: points");
}

}  // namespace
}  // namespace morphcl::test
