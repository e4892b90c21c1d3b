// Every way to write an object of a shot wrongly: kind, line and column, what is wrong and what would be right.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "host/scene/shot/mesh_library.hpp"
#include "host/scene/shot/shot_value.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

struct BadObject {
  const char* name;
  const char* object;    // the lines of [[object]] from line 2 on
  const char* expected;  // after "shot.toml:"
};
void PrintTo(const BadObject& wrong, std::ostream* out) { *out << wrong.name; }

class WrongObject : public ::testing::TestWithParam<BadObject> {};

TEST_P(WrongObject, IsRefusedWithItsPlace) {
  const ShotFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(folder.refusal(std::string("[[object]]\n") + GetParam().object),
            std::string("shot.toml:") + GetParam().expected);
}

std::string bad_object_name(const ::testing::TestParamInfo<BadObject>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Keys, WrongObject,
    ::testing::Values(
        BadObject{"NoMesh", "name = \"a\"", "1:1: object needs the key \"mesh\""},
        BadObject{"UnknownKey", "mesh = \"cube\"\ncolour = [1, 1, 1]",
                  "3:1: unknown key \"colour\" in object; did you mean \"color\"?"},
        BadObject{"NameTwice", "mesh = \"cube\"\nname = \"a\"\n[[object]]\nmesh = \"cube\"\nname = \"a\"",
                  "6:8: the name \"a\" is used twice"},
        BadObject{"NameEmpty", "mesh = \"cube\"\nname = \"\"", "3:8: name is empty"},
        BadObject{"MeshIsANumber", "mesh = 5", "2:8: mesh is an integer; a string is needed"},
        BadObject{"UnknownMesh", "mesh = \"sphree\"",
                  "2:8: mesh \"sphree\" is neither a built-in solid nor a .gltf, .glb or .obj file; did you mean "
                  "\"sphere\"?"},
        BadObject{"LaterShading", "mesh = \"cube\"\nshading = \"hidden_line\"",
                  "3:11: shading \"hidden_line\": not drawn by this version: flat, smooth, unlit and wireframe are"},
        BadObject{"UnknownShading", "mesh = \"cube\"\nshading = \"flatt\"",
                  "3:11: unknown shading \"flatt\"; did you mean \"flat\"?"},
        BadObject{"ColorOfTwo", "mesh = \"cube\"\ncolor = [1, 1]",
                  "3:9: color must be three or four numbers: [red, green, blue] or [red, green, blue, alpha]"},
        BadObject{"ColorNegative", "mesh = \"cube\"\ncolor = [0, -1, 0]", "3:13: color holds -1; 0 or more is needed"},
        BadObject{"AlphaAboveOne", "mesh = \"cube\"\ncolor = [0, 0, 0, 2]", "3:19: color holds 2; 0 to 1 is needed"},
        BadObject{"DoubleSidedText", "mesh = \"cube\"\ndouble_sided = \"yes\"",
                  "3:16: double_sided is a string; true or false is needed"},
        BadObject{"LineWidthZero", "mesh = \"cube\"\nline_width = 0",
                  "3:14: line_width is 0; more than 0 and at most 256 pixels is needed"},
        BadObject{"LineWidthNegative", "mesh = \"cube\"\nline_width = -2",
                  "3:14: line_width is -2; more than 0 and at most 256 pixels is needed"},
        BadObject{"LineWidthHuge", "mesh = \"cube\"\nline_width = 300",
                  "3:14: line_width is 300; more than 0 and at most 256 pixels is needed"},
        BadObject{"LineWidthNan", "mesh = \"cube\"\nline_width = nan", "3:14: line_width is nan; a number is needed"},
        BadObject{"LineWidthInfinite", "mesh = \"cube\"\nline_width = inf",
                  "3:14: line_width is inf; a finite number is needed"},
        BadObject{"LineWidthText", "mesh = \"cube\"\nline_width = \"2\"",
                  "3:14: line_width is a string; a number is needed"},
        BadObject{"SegmentsOfASolidWithoutThem", "mesh = \"cube\"\nsegments = [3, 3]",
                  "3:12: the solid \"cube\" takes no segments"},
        BadObject{"SegmentsTooFew", "mesh = \"sphere\"\nsegments = [2, 2]",
                  "3:12: segments [2, 2] are too few; \"sphere\" needs at least [3, 2]"},
        BadObject{"SegmentsTooMany", "mesh = \"sphere\"\nsegments = [100000, 100000]",
                  "3:12: segments [100000, 100000] make more than the 134217728 vertices that are allowed"},
        BadObject{"SegmentsHuge", "mesh = \"sphere\"\nsegments = [9000000000000000000, 3]",
                  "3:13: segments holds 9000000000000000000; 1 or more is needed"},
        BadObject{"SegmentsOfOne", "mesh = \"sphere\"\nsegments = 5", "3:12: segments must be two integers: [u, v]"}),
    bad_object_name);

INSTANTIATE_TEST_SUITE_P(Files, WrongObject,
                         ::testing::Values(BadObject{"SegmentsOfAFile", "mesh = \"a.obj\"\nsegments = [3, 3]",
                                                     "3:12: segments belong to a built-in solid, not to a file"},
                                           BadObject{"TargetsOfASolid", "mesh = \"cube\"\ntargets = [\"a.obj\"]",
                                                     "3:11: targets belong to an .obj file, not to a built-in solid"},
                                           BadObject{"TargetNotObj", "mesh = \"a.obj\"\ntargets = [\"b.gltf\"]",
                                                     "3:12: target \"b.gltf\" is not an .obj file"}),
                         bad_object_name);

INSTANTIATE_TEST_SUITE_P(
    Transform, WrongObject,
    ::testing::Values(
        BadObject{"NoKey", "mesh = \"cube\"\n[[object.transform]]",
                  "3:1: a transform step has exactly one key; this one has 0"},
        BadObject{"TwoKeys", "mesh = \"cube\"\n[[object.transform]]\nscale = [1, 1, 1]\ntranslate = [1, 1, 1]",
                  "3:1: a transform step has exactly one key; this one has 2"},
        BadObject{"UnknownStep", "mesh = \"cube\"\n[[object.transform]]\nrotate_x = 5",
                  "4:1: unknown key \"rotate_x\" in transform; did you mean \"rotate_x_degrees\"?"},
        BadObject{
            "SevenStepsAlongX",
            "mesh = \"cube\"\n[[object.transform]]\n"
            "rotate_in_seven_steps = { from = [0, 0, 0], to = [1, 0, 0], degrees = 5 }",
            "4:25: rotation in seven steps: the axis from (0, 0, 0) to (1, 0, 0) is parallel to x, and step 2 divides "
            "by 0; rotate_about_axis has no such gap"},
        BadObject{"EightOfSevenSteps",
                  "mesh = \"cube\"\n[[object.transform]]\n"
                  "rotate_in_seven_steps = { from = [0, 0, 0], to = [1, 1, 0], degrees = 5, steps = 8 }",
                  "4:82: steps is 8; 0 to 7 are possible"},
        BadObject{"TranslateNumber", "mesh = \"cube\"\n[[object.transform]]\ntranslate = 5",
                  "4:13: translate must be three numbers: [x, y, z]"},
        BadObject{"ScaleAboutWithoutPoint",
                  "mesh = \"cube\"\n[[object.transform]]\nscale_about = { factor = [1, 1, 1] }",
                  "4:15: scale_about needs the key \"point\""},
        BadObject{"MatrixOfDiagonalVectors",
                  "mesh = \"cube\"\n[[object.transform]]\nmatrix = { vectors = \"rows\", rows = [] }",
                  "4:22: unknown vectors \"rows\"; did you mean \"row\"?"},
        BadObject{"MatrixOfThreeRows",
                  "mesh = \"cube\"\n[[object.transform]]\nmatrix = [[1,0,0,0],[0,1,0,0],[0,0,1,0]]",
                  "4:10: matrix must be four rows of four numbers; the last is [0, 0, 0, 1]"}),
    bad_object_name);

#define TRACK "mesh = \"pyramid_to_cube\"\n[[object.track]]\n"
#define SPRING "target = \"morph.cube\"\ninterpolation = \"spring\"\n"
INSTANTIATE_TEST_SUITE_P(
    Track, WrongObject,
    ::testing::Values(
        BadObject{"NoTarget", TRACK "keys = [[0, 1]]", "3:1: track needs the key \"target\""},
        BadObject{"UnknownTarget", TRACK "target = \"rotatoin\"\nkeys = [[0, 1]]",
                  "4:10: an object has no value \"rotatoin\" to move; did you mean \"rotation\"?"},
        BadObject{"UnknownMorph", TRACK "target = \"morph.cuhe\"\nkeys = [[0, 1]]",
                  "4:10: the mesh has no morph target \"cuhe\"; did you mean \"cube\"?"},
        BadObject{"MorphOfAMeshWithout", "mesh = \"cube\"\n[[object.track]]\ntarget = \"morph.cube\"\nkeys = [[0, 1]]",
                  "4:10: morph.cube: the mesh has no morph targets"},
        BadObject{"Twice",
                  TRACK "target = \"scale\"\nkeys = [[0, [1, 1, 1]]]\n[[object.track]]\ntarget = \"scale\"\nkeys = []",
                  "7:10: scale is driven twice"},
        BadObject{
            "MorphTwice",
            TRACK
            "target = \"morph.cube\"\nkeys = [[0, 1]]\n[[object.track]]\ntarget = \"morph.cube\"\nkeys = [[0, 1]]",
            "7:10: morph.cube is driven twice"},
        BadObject{"SpringWithoutFrequency",
                  TRACK "target = \"morph.cube\"\ninterpolation = \"spring\"\nkeys = [[0, 1]]",
                  "3:1: track needs the key \"frequency\""},
        BadObject{"SpringOfNoFrequency", TRACK SPRING "frequency = 0\nkeys = [[0, 1]]",
                  "6:13: frequency is 0; 1e-06 to 10000000 Hz is possible"},
        BadObject{"SpringOfText", TRACK SPRING "frequency = \"2 Hz\"\nkeys = [[0, 1]]",
                  "6:13: frequency is a string; a number is needed"},
        BadObject{"SpringOfNegativeDamping", TRACK SPRING "frequency = 2\ndamping_ratio = -0.5\nkeys = [[0, 1]]",
                  "7:17: damping_ratio is -0.5; 0 to 1000000 is possible"},
        BadObject{"SpringFollowsASpring", TRACK SPRING "frequency = 2\nfollows = \"spring\"\nkeys = [[0, 1]]",
                  "7:11: unknown follows \"spring\"; known: step, linear, cubic"},
        BadObject{"SpringFollowsOneCubicKey", TRACK SPRING "frequency = 2\nfollows = \"cubic\"\nkeys = [[0, 1]]",
                  "8:8: a cubic track needs at least two keys"},
        BadObject{"FrequencyWithoutASpring", TRACK "target = \"morph.cube\"\nfrequency = 2\nkeys = [[0, 1]]",
                  "5:13: only a spring has a frequency"},
        BadObject{"VisibleOnASpring",
                  TRACK "target = \"visible\"\ninterpolation = \"spring\"\nfrequency = 2\nkeys = [[0, true]]",
                  "5:17: true and false have nothing between them; use \"step\""},
        BadObject{"UnknownInterpolation", TRACK "target = \"morph.cube\"\ninterpolation = \"linaer\"\nkeys = [[0, 1]]",
                  "5:17: unknown interpolation \"linaer\"; did you mean \"linear\"?"},
        BadObject{"NoKeys", TRACK "target = \"morph.cube\"\nkeys = []",
                  "5:8: keys is empty; a track needs at least one key"},
        BadObject{"KeyIsANumber", TRACK "target = \"morph.cube\"\nkeys = [0, 1]", "5:9: a key is [frame, value]"},
        BadObject{"KeysNotInOrder", TRACK "target = \"morph.cube\"\nkeys = [[0, 0], [5, 1], [3, 0]]",
                  "5:25: frame 3 does not come after frame 5; keys must be in order, one a frame"},
        BadObject{"KeysAtTheSameFrame", TRACK "target = \"morph.cube\"\nkeys = [[5, 0], [5.0, 1]]",
                  "5:17: frame 5 does not come after frame 5; keys must be in order, one a frame"},
        BadObject{"FrameTooLate", TRACK "target = \"morph.cube\"\nkeys = [[1e9, 0]]",
                  "5:10: frame 1000000000; frames reach from -1000000 to 1000000"},
        BadObject{"FrameNan", TRACK "target = \"morph.cube\"\nkeys = [[nan, 0]]",
                  "5:10: keys is nan; a number is needed"},
        BadObject{"ValueInfinite", TRACK "target = \"morph.cube\"\nkeys = [[0, inf]]",
                  "5:13: keys is inf; a finite number is needed"},
        BadObject{"TangentsOfALinearKey", TRACK "target = \"morph.cube\"\nkeys = [[0, 1, 0, 0]]",
                  "5:9: a key is [frame, value]"},
        BadObject{"CubicOfOneKey", TRACK "target = \"morph.cube\"\ninterpolation = \"cubic\"\nkeys = [[0, 1]]",
                  "6:8: a cubic track needs at least two keys"},
        BadObject{"CubicWithThree",
                  TRACK "target = \"morph.cube\"\ninterpolation = \"cubic\"\nkeys = [[0, 1, 0], [1, 1, 0]]",
                  "6:9: a cubic key is [frame, value] or [frame, value, in_tangent, out_tangent]"},
        BadObject{"TangentsOfSomeKeys",
                  TRACK "target = \"morph.cube\"\ninterpolation = \"cubic\"\nkeys = [[0, 1, 0, 0], [1, 1]]",
                  "6:23: either all keys of a track have tangents or none has"},
        BadObject{"RotationOfThree", TRACK "target = \"rotation\"\nkeys = [[0, [0, 0, 1]]]",
                  "5:13: a rotation is a quaternion [x, y, z, w] or { axis = [x, y, z], degrees = d }"},
        BadObject{"RotationZero", TRACK "target = \"rotation\"\nkeys = [[0, [0, 0, 0, 0]]]",
                  "5:13: the quaternion is [0, 0, 0, 0]; no rotation is written [0, 0, 0, 1]"},
        BadObject{"RotationWithoutAxis", TRACK "target = \"rotation\"\nkeys = [[0, { axis = [0, 0, 0], degrees = 1 }]]",
                  "5:22: the axis is [0, 0, 0]; it must have a direction"},
        BadObject{"RotationOfTooManyTurns",
                  TRACK "target = \"rotation\"\nkeys = [[0, {axis=[1,0,0],degrees=0}],[1,{axis=[1,0,0],degrees=1e9}]]",
                  "5:39: too many turns since the key before"},
        BadObject{
            "CubicRotationBeyondHalfATurn",
            TRACK "target = \"rotation\"\ninterpolation = \"cubic\"\n"
                  "keys = [[0, {axis=[1,0,0],degrees=0}],[1,{axis=[1,0,0],degrees=181}]]",
            "6:39: cubic rotation keys about one axis lie at most 180 degrees apart; add keys between, or use linear"},
        BadObject{"VisibleLinear", TRACK "target = \"visible\"\ninterpolation = \"linear\"\nkeys = [[0, true]]",
                  "5:17: true and false have nothing between them; use \"step\""}),
    bad_object_name);
#undef TRACK

TEST(WrongShotFile, MissingIsAnInputThatCannotBeRead) {
  const ShotFolder folder;
  try {
    load_scene(folder.path("none.toml"));
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cannot_read);
    EXPECT_EQ(error.place(), folder.path("none.toml"));
  }
}

// As for the shot itself.
TEST(WrongShotFile, NamesAModelThatIsMissing) {
  const ShotFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"none.obj\""),
            "cannot read: shot.toml:2:8: there is no file \"none.obj\"");
  EXPECT_EQ(folder.refusal("[[object]]\nmesh = \"a.obj\"\ntargets = [\"none.obj\"]"),
            "cannot read: shot.toml:3:12: there is no file \"none.obj\"");
}

TEST(WrongShotFile, OfAnotherKindIsAUsageError) {
  const ShotFolder folder;
  folder.write("picture.png", "");
  try {
    load_scene(folder.path("picture.png"));
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_EQ(error.message(), "not a scene; a .toml shot or a .gltf, .glb or .obj model is needed");
  }
}

TEST(WrongShotFile, WithNothingToDraw) {
  const ShotFolder folder;
  const std::string expected = "shot.toml:1:1: nothing to draw; a shot needs at least one [[object]] with a mesh";
  EXPECT_EQ(folder.refusal(""), expected);
  EXPECT_EQ(folder.refusal("object = []"), expected);
}

TEST(WrongShotFile, MayNotNameFilesOutsideItsFolder) {
  const ShotFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("deep/shot.toml", "[[object]]\nmesh = \"../a.obj\"\n");
  try {
    load_scene(folder.path("deep/shot.toml"));
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.place(), folder.path("deep/shot.toml") + ":2:8");
  }
  EXPECT_EQ(load_scene(folder.path("deep/shot.toml"),
                       {.allow_outside = true, .fps = {}, .width = {}, .height = {}, .stop = nullptr})
                .objects.size(),
            1u);
}

TEST(WrongShotFile, BuiltInSolidsHaveALimitTogether) {
  const std::string file = "shot.toml";
  const TomlValue document = parse_toml(
      "a = { mesh = \"cube\" }\nb = { mesh = \"grid\", segments = [3, 3] }\nc = { mesh = \"teapot\" }\n", file);
  const ShotTable shot = ShotValue(file, document, "a shot").table({"a", "b", "c"});
  const auto object = [&](const char* key) { return shot.need(key).table({"mesh", "segments"}); };
  MeshLibrary library(file, {}, {}, 24 + 16);
  library.model(object("a"));
  library.model(object("b"));
  library.model(object("a"));  // known already: not counted again
  try {
    library.model(object("c"));
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "shot.toml:3:14: the built-in solids have more than 40 vertices together");
  }
}

}  // namespace
}  // namespace morphcl
