// Meshes and morph targets out of .obj files, and what is refused.
#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>
#include <random>

#include "host/scene/obj/obj_import.hpp"
#include "morphcl/mesh.hpp"
#include "tests/scene/import_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

class ObjImport : public testing::Test {
 protected:
  Mesh mesh(const std::string& text) { return import_obj(folder.write("model.obj", text)).meshes[0]; }
  void expect_bad(const std::string& text, const std::string& line, const std::string& words) {
    const std::string path = folder.write("model.obj", text);
    expect_refusal([&] { import_obj(path); }, ErrorKind::bad_input, path + line, words);
  }
  void expect_bad_target(const std::string& neutral, const std::string& target, const std::string& line,
                         const std::string& words) {
    const std::string neutral_path = folder.write("neutral.obj", neutral), path = folder.write("smile.obj", target);
    expect_refusal([&] { import_obj_targets(neutral_path, {path}); }, ErrorKind::bad_input, path + line, words);
  }
  test_support::TemporaryFolder folder;
};

glm::vec4 default_color() { return glm::vec4(Material{}.base_color); }

using Triangles = std::vector<glm::uvec3>;
using Edges = std::vector<glm::uvec2>;
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjImport, IsStoppedWhileItReads) {
  const std::atomic<bool> stop = true;
  ImportLimits limits;
  limits.stop = &stop;
  const std::string path = folder.write("model.obj", "# only\nvt 0 0\ns 1\n");
  expect_refusal([&] { import_obj(path, limits); }, ErrorKind::interrupted, path, "interrupted");
}

TEST_F(ObjImport, Utf16IsNamed) {
  std::string text = "\xff\xfe";
  for (const char c : square + "f 1 2 3 4\n") text += {c, '\0'};
  expect_bad(text, "", "is text in UTF-16; save it as UTF-8");
  expect_bad(text.substr(2), "", "is text in UTF-16; save it as UTF-8");
}

TEST_F(ObjImport, TheFilesThatWereReadAreNamed) {
  const std::string library = folder.write("colors.mtl", "newmtl red\nKd 1 0 0\n");
  const std::string path = folder.write("model.obj", "mtllib colors.mtl\nusemtl red\n" + square + "f 1 2 3 4\n");
  const std::vector<std::string> inputs = import_obj(path).inputs;
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[0], path);
  EXPECT_EQ(std::filesystem::path(inputs[1]).filename(), "colors.mtl");
}

TEST_F(ObjImport, QuadKeepsItsOwnSides) {
  const ImportedModel model = import_obj(folder.write("plate.obj", square + "f 1 2 3 4\n"));
  const Mesh& plate = model.meshes[0];
  EXPECT_EQ(plate.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(plate.edges, (Edges{{0, 1}, {0, 3}, {1, 2}, {2, 3}}));
  EXPECT_TRUE(plate.normals.empty());
  EXPECT_EQ(plate.name, "plate");
  ASSERT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.objects[0].name, "plate");
  EXPECT_TRUE(model.objects[0].material.double_sided);
  EXPECT_EQ(model.objects[0].material.shading, Shading::smooth) << "by the normals of its faces";
  EXPECT_EQ(model.objects.size(), 1u);
  EXPECT_EQ(model.duration_seconds, 0);
  EXPECT_TRUE(model.warnings.empty());
}

TEST_F(ObjImport, EveryWayToWriteACorner) {
  const std::string head = square + "vt 0 0\nvn 0 0 2\n";
  for (const std::string face : {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -4 -3 -2",
                                 "f -4/-1/-1 -3/-1/-1 -2/-1/-1", "f 1/ 2/ 3/", "fo 1 2 3"}) {
    const Mesh read = mesh(head + face);
    EXPECT_EQ(read.triangles, (Triangles{{0, 1, 2}})) << face;
    EXPECT_EQ(read.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}})) << face;
    const bool has_normals = face.find("//") != std::string::npos || face.find("/1/1") != std::string::npos ||
                             face.find("/-1/-1") != std::string::npos;
    EXPECT_EQ(read.normals, std::vector<glm::vec3>(has_normals ? 3 : 0, {0, 0, 1})) << face;
  }
}

TEST_F(ObjImport, NegativeIndicesCountBackFromTheFace) {
  const Mesh read = mesh("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\nv 5 5 5\nf -1 -2 -3\n");
  EXPECT_EQ(read.triangles, (Triangles{{2, 1, 0}, {3, 2, 1}}));
  EXPECT_EQ(read.positions[3], glm::vec3(5, 5, 5));
}

TEST_F(ObjImport, VertexWithTwoNormalsIsSplitAndItsSideDrawnOnce) {
  const Mesh read = mesh(square + "v 0 0 1\nvn 0 0 1\nvn 0 -1 0\nf 1//1 2//1 3//1\nf 1//2 2//2 5//2\n");
  EXPECT_EQ(read.positions.size(), 6u);
  EXPECT_EQ(read.edges.size(), 5u) << "the shared side counts once";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.normals[read.triangles[0][static_cast<int>(i)]], glm::vec3(0, 0, 1));
    EXPECT_EQ(read.normals[read.triangles[1][static_cast<int>(i)]], glm::vec3(0, -1, 0));
  }
}

TEST_F(ObjImport, TextureCoordinatesSplitVerticesAndLeaveTheRestAlone) {
  const std::string coordinates = "vt 0 0\nvt 1 0.25\nvt 0.5\nvt 1 0.25 7\n";  // the last is the second again
  const Mesh plain = mesh(square + "f 1 2 3\nf 1 3 4\n");
  const Mesh read = mesh(square + coordinates + "f 1/1 2/2 3/3\nf 1/1 3/2 4/4\n");
  ASSERT_EQ(read.positions.size(), 5u) << "the third point has two";
  EXPECT_EQ(read.triangles, (Triangles{{0, 1, 3}, {0, 2, 4}}));
  EXPECT_EQ(read.uvs, (std::vector<glm::vec2>{{0, 0}, {1, 0.25f}, {1, 0.25f}, {0.5f, 0}, {1, 0.25f}}));
  EXPECT_TRUE(read.normals.empty());
  EXPECT_EQ(read.edges.size(), distinct_edges(plain.triangles).size()) << "each side once";
  EXPECT_TRUE(plain.uvs.empty());
}

TEST_F(ObjImport, EqualTextureCoordinatesAreOneHoweverOftenTheyStandThere) {
  const Mesh read = mesh(square + "vt 0.5 0.5\nvt 0.5 0.5\nvt 0.5 0.5\nf 1/1 2/2 3/3\nf 1/3 3/2 4/1\n");
  EXPECT_EQ(read.positions.size(), 4u);
  EXPECT_EQ(read.uvs, std::vector<glm::vec2>(4, glm::vec2(0.5f)));
}

TEST_F(ObjImport, AbsentTextureCoordinatesAreZeroAndWrongOnesAreNamed) {
  const ImportedModel some = import_obj(folder.write("a.obj", square + "vt 1 1\nf 1/1 2 3\nf 1/1 3 4\n"));
  EXPECT_EQ(some.meshes[0].uvs, (std::vector<glm::vec2>{{1, 1}, {0, 0}, {0, 0}, {0, 0}}));
  EXPECT_TRUE(some.warnings.empty());
  for (const std::string wrong : {"vt x 1\n", "vt 1 nan\n", ""}) {
    const ImportedModel model = import_obj(folder.write("a.obj", square + wrong + "vt 1 1\nf 1/1 2/2 3/2\n"));
    ASSERT_EQ(model.warnings.size(), 1u) << wrong;
    EXPECT_NE(
        model.warnings[0].find(
            wrong.empty() ? "the texture coordinates of 2 of 3 face corners are missing or no numbers; 0 is used"
                          : "the texture coordinates of 1 of 3 face corners are missing or no numbers; 0 is used"),
        std::string::npos)
        << model.warnings[0];
  }
}

// A target's normals are those of the position and the normal, as they were without texture coordinates.
TEST_F(ObjImport, TextureCoordinatesDoNotMoveATargetsNormals) {
  const auto file = [](const char* corners, const char* normals) {
    return square + "vt 0 0\nvt 1 1\n" + normals + corners;
  };
  const char* const plain = "f 1//1 2//1 3//1\nf 1//1 3//1 4//1\n";
  const char* const textured = "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/2/1 4/2/1\n";
  const std::string target =
      folder.write("t.obj", file("f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n", "vn 0 0 1\nvn 0 1 0\n"));
  const auto normals_of = [&](const char* corners) {
    const ImportedModel model = import_obj_targets(folder.write("n.obj", file(corners, "vn 0 0 1\n")), {target});
    std::vector<glm::vec3> normals;
    for (const glm::uvec3& triangle : model.meshes[0].triangles)
      for (int c = 0; c < 3; ++c) normals.push_back(model.meshes[0].targets[0].normals[triangle[c]]);
    return normals;
  };
  EXPECT_EQ(normals_of(plain), normals_of(textured));
}

TEST_F(ObjImport, MaterialsHaveTheirNames) {
  const ImportedModel model = import_obj(folder.write("car.obj", square + "f 1 2 3\nusemtl red paint\nf 1 3 4\n"));
  ASSERT_EQ(model.objects.size(), 2u);
  EXPECT_EQ(model.objects[0].material.name, "");
  EXPECT_EQ(model.objects[1].material.name, "red paint");
}

TEST_F(ObjImport, MissingNormalsAtSomeCornersLightTheFacesFlat) {
  const ImportedModel model = import_obj(folder.write("a.obj", square + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n"));
  EXPECT_TRUE(model.meshes[0].normals.empty());
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("lit flat"), std::string::npos);
}

TEST_F(ObjImport, NumbersDoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "C.UTF-8"}) std::setlocale(LC_ALL, name);
  const Mesh read = mesh("v 0.1 2.5e-1 -3.75\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(read.positions[0], glm::vec3(0.1f, 0.25f, -3.75f));
}

TEST_F(ObjImport, VertexColorsOfEveryVertex) {
  EXPECT_EQ(mesh("v 0 0 0 1 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0 2 -1 0\nf 1 2 3\n").colors[2], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(mesh("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 nan 0 0\nf 1 2 3\n").colors,
            (std::vector<glm::vec4>{{1, 0.5f, 0, 1}, default_color(), default_color()}));
  EXPECT_TRUE(mesh("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").colors.empty()) << "a weight is no colour";
}

TEST_F(ObjImport, MaterialColor) {
  folder.write("paint.mtl", "newmtl blue\nKd 0 0 1\nnewmtl red\r\nNs 5\r\n\tKd 1 0.5 0.25\r\nnewmtl red\nKd 0 1 0\n");
  const std::string head = "mtllib paint.mtl\n" + square;
  ImportedModel model = import_obj(folder.write("a.obj", head + "usemtl red\nf 1 2 3 4\n"));
  EXPECT_EQ(model.objects[0].material.base_color, glm::dvec4(1, 0.5, 0.25, 1));
  EXPECT_TRUE(model.warnings.empty());
  model = import_obj(folder.write("a.obj", head + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n"));
  ASSERT_EQ(model.objects.size(), 2u) << "one a material";
  EXPECT_EQ(model.objects[0].name, "a.red");
  EXPECT_EQ(model.objects[0].material.base_color, glm::dvec4(1, 0.5, 0.25, 1));
  EXPECT_EQ(model.objects[1].name, "a.blue");
  EXPECT_EQ(model.objects[1].material.base_color, glm::dvec4(0, 0, 1, 1));
  EXPECT_TRUE(model.warnings.empty());
}

TEST_F(ObjImport, MaterialFileThatIsMissingOrOutside) {
  ImportedModel model = import_obj(folder.write("a.obj", "mtllib none.mtl\nusemtl x\n" + square + "f 1 2 3 4\n"));
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("none.mtl: No such file"), std::string::npos) << model.warnings[0];
}

TEST_F(ObjImport, WhatIsNotDrawnIsNamed) {
  const std::string text = square + "g a\no b\ns 1\nl 1 2\np 1\ncurv 0 1 1 2\nf 1 2 3 4\n";
  EXPECT_EQ(import_obj(folder.write("a.obj", text)).warnings,
            std::vector<std::string>{"not drawn: lines, points, statement curv"});
}

TEST_F(ObjImport, MorphTargetsAreAbsoluteAndNamedByTheirFiles) {
  const std::string neutral = folder.write("neutral.obj", square + "v 7 7 7\nf 1 2 3 4\n");
  const std::string wide = folder.write("wide.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 8 8 8\n# note\nf 1 2 3 4\n");
  const ImportedModel model = import_obj_targets(neutral, {wide, neutral});
  const Mesh& read = model.meshes[0];
  ASSERT_EQ(read.targets.size(), 2u);
  EXPECT_EQ(read.targets[0].name, "wide");
  EXPECT_EQ(read.targets[0].form, TargetForm::absolute);
  EXPECT_EQ(read.targets[0].positions, (std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(read.targets[1].positions, read.positions);
  EXPECT_TRUE(read.targets[0].normals.empty());
  EXPECT_EQ(model.objects[0].morph.weights, (std::vector<double>{0, 0}));
  EXPECT_NE(model.content_hash, import_obj(neutral).content_hash);
}

TEST_F(ObjImport, TargetNormalsFollowTheCornersWhateverTheirNumbers) {
  const std::string neutral =
      folder.write("n.obj", square + "v 0 0 1\nvn 0 0 1\nvn 0 -1 0\nf 1//1 2//1 3//1\nf 1//2 2//2 5//2\n");
  const std::string turned =
      folder.write("t.obj", square + "v 0 0 2\nvn 3 0 0\nvn 0 1 0\nvn 0 0 -1\nf 1//2 2//2 3//2\nf 1//1 2//1 5//3\n");
  const Mesh read = import_obj_targets(neutral, {turned}).meshes[0];
  const std::vector<glm::vec3>& normals = read.targets[0].normals;
  ASSERT_EQ(normals.size(), read.positions.size());
  EXPECT_EQ(normals[read.triangles[0][0]], glm::vec3(0, 1, 0));
  EXPECT_EQ(normals[read.triangles[1][0]], glm::vec3(1, 0, 0));
  EXPECT_EQ(normals[read.triangles[1][2]], glm::vec3(0, 0, -1));
}

TEST_F(ObjImport, TargetsOfAnotherTopologyAreRefused) {
  const std::string neutral = square + "f 1 2 3\nf 1 3 4\n";
  expect_bad_target(neutral, square + "v 0 0 0\nf 1 2 3\nf 1 3 4\n", "", "has 5 vertices (v), but");
  expect_bad_target(neutral, square + "f 1 2 3\n\nf 1 4 3\n", ":7", "face 2 has other vertices than at");
  expect_bad_target(neutral, square + "f 1 2 3\nf 1 3 4\nf 1 2 4\n", ":7", "face 3 is one more than");
  expect_bad_target(neutral, square + "f 1 2 3\n", "", "has 1 faces, but");
  expect_bad_target(neutral, square + "f 1 2 3 4\nf 1 3 4\n", ":5", "face 1 has other vertices");
}

TEST_F(ObjImport, BadLinesAreNamedByNumber) {
  expect_bad(square + "f 1 2 5\n", ":5", "vertex 5 does not exist; the file has 4");
  expect_bad(square + "f 1 2 0\n", ":5", "indices start at 1");
  expect_bad(square + "f 1 2 -5\n", ":5", "vertex -5 does not exist");
  expect_bad(square + "f 1 2 99999999999\n", ":5", "does not exist");
  expect_bad(square + "f 1 2 x\n", ":5", "'x' is not the index of a vertex");
  expect_bad(square + "f 1//x 2//1 3//1\n", ":5", "'1//x' is not a face corner");
  expect_bad(square + "f /1/1 2//1 3//1\n", ":5", "'' is not the index of a vertex");
  expect_bad("v 0 0\n", ":1", "3, 4, 6 or 7 numbers, not 2");
  expect_bad("v 0 0 nan\n", ":1", "'nan' is not a number that is finite");
  expect_bad("\n\nv 0 1e39 0\n", ":3", "'1e39'");
  expect_bad("v 0 0 0 1 2 3 4 5\n", ":1", "at most 7");
  expect_bad("v 0 0 0 nan\n", ":1", "the weight, is not a number");
  expect_bad("v 0 0 -1.#IND\n", ":1", "'-1.#IND' is not a number that is finite");
  expect_bad(square, "", "holds no faces");
  expect_bad("", "", "holds no faces");
  expect_bad(std::string(1000, '\0'), "", "holds no faces");
}

TEST_F(ObjImport, MissingFileAndLimits) {
  const std::string path = (folder.path() / "none.obj").string();
  expect_refusal([&] { import_obj(path); }, ErrorKind::cannot_read, path, "No such file");
  const std::string model = folder.write("a.obj", square + "f 1 2 3 4\n");
  ImportLimits limits;
  limits.max_vertices = 3;
  expect_refusal([&] { import_obj(model, limits); }, ErrorKind::bad_input, model + ":4", "more than 3 vertices");
  limits = {};
  limits.max_decoded_bytes = 10;
  expect_refusal([&] { import_obj(model, limits); }, ErrorKind::bad_input, model, "at most 10 are read");
  limits.max_decoded_bytes = 150;
  expect_refusal([&] { import_obj(model, limits); }, ErrorKind::bad_input, model, "one model may take");
}

TEST_F(ObjImport, DamagedFilesAreRefusedOrRead) {
  const std::string whole = square + "vn 0 0 1\nusemtl a\nf 1//1 2//1 3//1 4//1\nf -1 \\\n-2 -3\n";
  std::mt19937 random(11);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(random() % limit); };
  const std::string alphabet = "0123456789-.e/ \n\\vfn#\t\xff";
  int read = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole.substr(0, i < 200 ? below(whole.size()) : whole.size());
    for (std::size_t change = 0; change <= below(3) && !bytes.empty(); ++change)
      bytes[below(bytes.size())] = alphabet[below(alphabet.size())];
    const std::string path = folder.write("damaged.obj", bytes);
    try {
      const ImportedModel model = import_obj(path);
      for (const Mesh& mesh : model.meshes) validate(mesh);
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 1900);
}

}  // namespace
}  // namespace morphcl::test
