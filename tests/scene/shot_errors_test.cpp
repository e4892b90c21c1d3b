// Every way to write a shot wrongly: kind, line and column, what is wrong and what would be right.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

struct BadShot {
  const char* name;
  const char* shot;      // one more object with the mesh "cube" is added after it
  const char* expected;  // after "shot.toml:"
};
void PrintTo(const BadShot& wrong, std::ostream* out) { *out << wrong.name; }

class WrongShot : public ::testing::TestWithParam<BadShot> {};

TEST_P(WrongShot, IsRefusedWithItsPlace) {
  const ShotFolder folder;
  const std::string shot = std::string(GetParam().shot) + "\n" + std::string(test::cube_object);
  EXPECT_EQ(folder.refusal(shot), std::string("shot.toml:") + GetParam().expected);
}

// The text of a syntax error is the TOML library's; its place is ours to keep.
TEST(WrongSyntax, IsRefusedWithItsPlace) {
  const ShotFolder folder;
  EXPECT_EQ(folder.refusal("[frames]\nfps = = 25").substr(0, 15), "shot.toml:2:7: ");
  EXPECT_EQ(folder.refusal("[frames]\nfps = 25\nfps = 24").substr(0, 12), "shot.toml:3:");
  EXPECT_EQ(folder.refusal("[frames\nfps = 25").substr(0, 12), "shot.toml:1:");
}

std::string bad_shot_name(const ::testing::TestParamInfo<BadShot>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Syntax, WrongShot,
    ::testing::Values(
        BadShot{"UnknownTable", "[camra]\nnear = 1", "1:2: unknown key \"camra\" in a shot; did you mean \"camera\"?"},
        BadShot{"UnknownKey", "[frames]\nfsp = 25", "2:1: unknown key \"fsp\" in frames; did you mean \"fps\"?"},
        BadShot{"UnknownKeyFarFromAny", "[frames]\nzoom = 25",
                "2:1: unknown key \"zoom\" in frames; known: range, fps"},
        BadShot{"OneTableInsteadOfSeveral", "[light]\ndirection = [0, 0, 1]",
                "1:1: light is one table; several are possible, so write it with [[ ]]"},
        BadShot{"TableIsAValue", "image = 5", "1:9: image is an integer; a table is needed"},
        BadShot{"Date", "[frames]\nfps = 2020-01-01", "2:7: fps is a date; an integer is needed"},
        BadShot{"LongDottedKey", "a.b.c.d.e.f.g.h.i = 1", "1:16: a key of more than 8 parts"}),
    bad_shot_name);

INSTANTIATE_TEST_SUITE_P(
    Lens, WrongShot,
    ::testing::Values(
        BadShot{"FocalLengthZero", "[camera]\nfocal_length = 0", "2:16: focal_length is 0; a number above 0 is needed"},
        BadShot{"FocalLengthBesideFovy", "[camera]\nfocal_length = 50\nfovy_degrees = 40",
                "3:16: focal_length and fovy_degrees are both given; one says it all"},
        BadShot{"FilmAlone", "[camera]\nfilm = [36, 24]", "2:8: film belongs to a focal_length; give both"},
        BadShot{"FilmOfOne", "[camera]\nfocal_length = 50\nfilm = [36]",
                "3:8: film must be two numbers: [width, height]"},
        BadShot{"FocalLengthOfAFrustum", "[camera]\nprojection = \"frustum\"\nfocal_length = 50",
                "3:16: the projection \"frustum\" has no focal_length"},
        BadShot{"ProjectorsAlongThePicture", "[camera]\nprojection = \"oblique\"\nprojectors = [1, 0, 0]",
                "3:14: the projectors' direction is (1, 0, 0); it must be finite and lead through the picture's plane "
                "z = 0 at "
                "1 degree or more"},
        BadShot{"ProjectorsBesideTheFactor", "[camera]\nprojection = \"oblique\"\nfactor = 1\nprojectors = [1, 0, 1]",
                "3:10: projectors and factor are both given; one says it all"},
        BadShot{"ProjectorsOfACabinet", "[camera]\nprojection = \"cabinet\"\nprojectors = [1, 0, 1]",
                "3:14: the projection \"cabinet\" has no projectors"}),
    bad_shot_name);

INSTANTIATE_TEST_SUITE_P(
    Image, WrongShot,
    ::testing::Values(
        BadShot{"SizeIsText", "[image]\nsize = \"big\"", "2:8: size must be two integers: [width, height] in pixels"},
        BadShot{"SizeOfThree", "[image]\nsize = [1, 2, 3]",
                "2:8: size must be two integers: [width, height] in pixels"},
        BadShot{"SizeZero", "[image]\nsize = [0, 18]", "2:9: size is 0 pixels; 1 to 16384 are possible"},
        BadShot{"SizeNegative", "[image]\nsize = [32, -18]", "2:13: size is -18 pixels; 1 to 16384 are possible"},
        BadShot{"SizeAbsurd", "[image]\nsize = [32, 1000000000000]",
                "2:13: size is 1000000000000 pixels; 1 to 16384 are possible"},
        BadShot{"SizeJustTooLarge", "[image]\nsize = [16385, 1]", "2:9: size is 16385 pixels; 1 to 16384 are possible"},
        BadShot{"SizeFraction", "[image]\nsize = [32.5, 18]", "2:9: size is a number; an integer is needed"},
        BadShot{"ChannelOfAnotherCase", "[image]\nchannels = [\"RGBA\", \"Velocity\"]",
                "2:21: unknown channel \"Velocity\"; did you mean \"velocity\"?"},
        BadShot{
            "ChannelOfAnotherProgram", "[image]\nchannels = [\"IndexMA\"]",
            "2:13: unknown channel \"IndexMA\"; known: RGBA, Z, N, P, velocity, uv, albedo, object_id, material_id, "
            "coverage, crypto_object, crypto_material"},
        BadShot{
            "LossyIds", "[image]\nchannels = [\"RGBA\", \"crypto_object\"]\ncompression = \"dwaa\"",
            "3:15: compression \"dwaa\" is lossy, and channel crypto_object holds ids, which it would change; none, "
            "rle, zips, zip, zip:small and piz keep every bit"},
        BadShot{"UnknownChannelNames", "[image]\nchannel_names = \"nuk\"",
                "2:17: unknown channel_names \"nuk\"; did you mean \"nuke\"?"},
        BadShot{"UnknownChannel", "[image]\nchannels = [\"RGB\"]",
                "2:13: unknown channel \"RGB\"; did you mean \"RGBA\"?"},
        BadShot{"ChannelTwice", "[image]\nchannels = [\"Z\", \"Z\"]", "2:18: channel \"Z\" is named twice"},
        BadShot{"NoChannel", "[image]\nchannels = []", "2:12: channels is empty; name RGBA, Z or others"},
        BadShot{"ChannelsText", "[image]\nchannels = \"RGBA\"", "2:12: channels is a string; an array is needed"},
        BadShot{"NoSamples", "[image]\nsamples = 0", "2:11: samples is 0; 1, 2, 4, 8 or 16 are possible"},
        BadShot{"SamplesAsText", "[image]\nsamples = \"4\"", "2:11: samples is a string; an integer is needed"},
        BadShot{"WrongSamples", "[image]\nsamples = 3", "2:11: samples is 3; 1, 2, 4, 8 or 16 are possible"},
        BadShot{"UnknownVisibility", "[image]\nvisibility = \"painters\"",
                "2:14: unknown visibility \"painters\"; did you mean \"painter\"?"},
        BadShot{"VisibilityOfSamples", "[image]\nsamples = 4\nvisibility = \"bsp\"",
                "3:14: visibility bsp takes one sample a pixel, not 4; ask for samples 1, or for z-buffer"},
        BadShot{"UnknownDepthBuffer", "[image]\ndepth_buffer = \"fixed23\"",
                "2:16: unknown depth_buffer \"fixed23\"; did you mean \"fixed24\"?"},
        BadShot{"ZErrorZero", "[image]\nz_error = 0",
                "2:11: z_error is 0; a relative error above 0 and of at most 0.1 is needed, such as 1e-6"},
        BadShot{"ZErrorNegative", "[image]\nz_error = -1e-6",
                "2:11: z_error is -1e-06; a relative error above 0 and of at most 0.1 is needed, such as 1e-6"},
        BadShot{"ZErrorTooLarge", "[image]\nz_error = 1",
                "2:11: z_error is 1; a relative error above 0 and of at most 0.1 is needed, such as 1e-6"},
        BadShot{"ZErrorInfinite", "[image]\nz_error = inf",
                "2:11: z_error is inf; a relative error above 0 and of at most 0.1 is needed, such as 1e-6"},
        BadShot{"ZErrorNan", "[image]\nz_error = nan", "2:11: z_error is nan; a number is needed"},
        BadShot{"ZErrorText", "[image]\nz_error = \"1e-6\"", "2:11: z_error is a string; a number is needed"},
        BadShot{"ZErrorWithoutZ", "[image]\nz_error = 1e-6\nchannels = [\"RGBA\"]",
                "2:11: z_error is of channel Z, which is not among the channels; add \"Z\" to them, or leave it out"},
        BadShot{"PErrorWithoutP", "[image]\np_error = 1e-6",
                "2:11: p_error is of channel P, which is not among the channels; add \"P\" to them, or leave it out"},
        BadShot{"NErrorTooLarge", "[image]\nchannels = [\"N\"]\nn_error = 0.2",
                "3:11: n_error is 0.2; an absolute error above 0 and of at most 0.1 is needed, such as 1e-3"},
        BadShot{"ErrorOfAnotherChannel", "[image]\nuv_error = 1e-6",
                "2:1: unknown key \"uv_error\" in image; did you mean \"z_error\"?"},
        BadShot{"AccuracyWithoutPixels", "[accuracy]\n",
                "1:1: accuracy needs pixels: how far a vertex may be from its exact place"},
        BadShot{"AccuracyOfNothing", "[accuracy]\npixels = 0", "2:10: pixels is 0; a number above 0 is needed"},
        BadShot{"UnknownCompression", "[image]\ncompression = \"zipp\"",
                "2:15: unknown compression \"zipp\"; did you mean \"zips\"?"}),
    bad_shot_name);

INSTANTIATE_TEST_SUITE_P(
    Frames, WrongShot,
    ::testing::Values(
        BadShot{"Empty", "[frames]\nrange = \"\"",
                "2:9: frame range \"\": a frame is missing; write for example 7, 1-10 or 1-10x2,20"},
        BadShot{"Backwards", "[frames]\nrange = \"5-1\"", "2:9: frame range \"5-1\": 5-1 runs backwards; write 1-5"},
        BadShot{"Colon", "[frames]\nrange = \"1:5\"",
                "2:9: frame range \"1:5\": ':' is a step in some farms and an interleaved order in others; write the "
                "step as "
                "1-10x2"},
        BadShot{"TooMany", "[frames]\nrange = \"0-1000000\"", "2:9: more than 1000000 frames are asked for"},
        BadShot{"RangeIsANumber", "[frames]\nrange = 5", "2:9: range is an integer; a string is needed"},
        BadShot{"FpsZero", "[frames]\nfps = 0", "2:7: fps holds 0; 1 to 1000000 is possible"},
        BadShot{"FpsFraction", "[frames]\nfps = 23.976",
                "2:7: fps is 23.976; a rate is an integer or a ratio of two, exactly: fps = [24000, 1001]"},
        BadShot{"FpsDenominatorZero", "[frames]\nfps = [24000, 0]", "2:15: fps holds 0; 1 to 1000000 is possible"},
        BadShot{"FpsOfThree", "[frames]\nfps = [1, 2, 3]", "2:7: fps must be an integer or [numerator, denominator]"}),
    bad_shot_name);

INSTANTIATE_TEST_SUITE_P(
    Camera, WrongShot,
    ::testing::Values(
        BadShot{"NearBeyondFar", "[camera]\nnear = 10\nfar = 1.0",
                "3:7: near is 10 and far is 1; far must be greater than near"},
        BadShot{"NearBeyondTheStandardFar", "[camera]\nnear = 100.0\neye = [0, 0, 5]",
                "2:8: near is 100 and far is 100; far must be greater than near"},
        BadShot{"NearZero", "[camera]\nnear = 0.0", "2:8: near is 0; a number above 0 is needed"},
        BadShot{"FarNan", "[camera]\nfar = nan", "2:7: far is nan; a number is needed"},
        BadShot{"FarMinusInfinity", "[camera]\nfar = -inf", "2:7: far is -inf; a number is needed"},
        BadShot{"NearInfinite", "[camera]\nnear = inf", "2:8: near is inf; a finite number is needed"},
        BadShot{"FovyZero", "[camera]\nfovy_degrees = 0",
                "2:16: fovy_degrees is 0 degrees; more than 0 and less than 180 is needed"},
        BadShot{"FovyStraight", "[camera]\nfovy_degrees = 180.0",
                "2:16: fovy_degrees is 180 degrees; more than 0 and less than 180 is needed"},
        BadShot{"FovyText", "[camera]\nfovy_degrees = \"wide\"", "2:16: fovy_degrees is a string; a number is needed"},
        BadShot{"UnknownProjection", "[camera]\nprojection = \"perspectiv\"",
                "2:14: unknown projection \"perspectiv\"; did you mean \"perspective\"?"},
        BadShot{"WindowOfAPerspective", "[camera]\nleft = -1", "2:8: the projection \"perspective\" has no left"},
        BadShot{"FovyOfAFrustum", "[camera]\nprojection = \"frustum\"\nfovy_degrees = 45",
                "3:16: the projection \"frustum\" has no fovy_degrees"},
        BadShot{"EmptyWindow", "[camera]\nprojection = \"frustum\"\nleft = 2\nright = 2",
                "4:9: left is 2 and right is 2; right must be greater"},
        BadShot{"WindowUpsideDown", "[camera]\nprojection = \"orthographic\"\nbottom = 5",
                "3:10: bottom is 5 and top is 1; top must be greater"},
        BadShot{"OrthographicInfinite", "[camera]\nprojection = \"orthographic\"\nfar = inf",
                "3:7: far is inf; a finite number is needed"},
        BadShot{"EyeIsTarget", "[camera]\neye = [0, 0, 0]", "2:7: eye and target are the same point"},
        BadShot{"EyeOfTwo", "[camera]\neye = [0, 0]", "2:7: eye must be three numbers: [x, y, z]"},
        BadShot{"EyeNan", "[camera]\neye = [3.0, nan, 0]", "2:13: eye is nan; a number is needed"},
        BadShot{"UpZero", "[camera]\nup = [0, 0, 0]", "2:6: up is [0, 0, 0]; it must have a direction"},
        BadShot{"TrackOfNothing", "[camera]\n[[camera.track]]\ntarget = \"eyes\"\nkeys = [[0, 1]]",
                "3:10: a camera has no value \"eyes\" to move; did you mean \"eye\"?"},
        BadShot{"TrackTwice",
                "[camera]\n[[camera.track]]\ntarget = \"near\"\nkeys = [[0, 1]]\n[[camera.track]]\ntarget = \"near\"\n"
                "keys = [[0, 1]]",
                "6:10: near is driven twice"},
        BadShot{"TrackOfNearZero", "[camera]\n[[camera.track]]\ntarget = \"near\"\nkeys = [[0, 0]]",
                "4:13: keys is 0; a number above 0 is needed"},
        BadShot{"TrackOfFovyTooWide", "[camera]\n[[camera.track]]\ntarget = \"fovy_degrees\"\nkeys = [[0, 200]]",
                "4:13: keys is 200 degrees; more than 0 and less than 180 is needed"},
        BadShot{"FovyTrackOfAFrustum",
                "[camera]\nprojection = \"frustum\"\n[[camera.track]]\ntarget = \"fovy_degrees\"\nkeys = [[0, 20]]",
                "4:10: only a perspective projection has fovy_degrees, and only one without fovx_degrees"}),
    bad_shot_name);

INSTANTIATE_TEST_SUITE_P(
    Drawings, WrongShot,
    ::testing::Values(
        BadShot{"TwoFieldsOfView", "[camera]\nfovy_degrees = 40\nfovx_degrees = 50",
                "3:16: fovy_degrees and fovx_degrees are both given; one says it all"},
        BadShot{"FovxTrackWithoutFovx", "[camera]\n[[camera.track]]\ntarget = \"fovx_degrees\"\nkeys = [[0, 20]]",
                "3:10: only a perspective projection that has fovx_degrees can move it"},
        BadShot{"EyeOfAnIsometric", "[camera]\nprojection = \"isometric\"\neye = [1, 1, 1]",
                "3:7: the projection \"isometric\" has no eye"},
        BadShot{"FactorOfACabinet", "[camera]\nprojection = \"cabinet\"\nfactor = 0.5",
                "3:10: the projection \"cabinet\" has no factor"},
        BadShot{"ObliqueOfNoAngle", "[camera]\nprojection = \"oblique\"",
                "1:1: an oblique projection needs a factor, beta_degrees or projectors: 1 or 45 is cavalier, 0.5 is "
                "cabinet"},
        BadShot{"ObliqueTwice", "[camera]\nprojection = \"oblique\"\nfactor = 1\nbeta_degrees = 45",
                "4:16: factor and beta_degrees are both given; one says it all"},
        BadShot{"ObliqueTooFlat", "[camera]\nprojection = \"oblique\"\nbeta_degrees = 1e-4",
                "3:16: beta_degrees is 0.0001; it must be between 1 and 90: the closer the projectors run to the "
                "picture's plane, the more an error of the angle moves the picture"},
        BadShot{
            "ObliqueTooLong", "[camera]\nprojection = \"oblique\"\nfactor = 58",
            "3:10: factor is 58; it must be between 0 and 57.29: beyond, the projectors run closer than 1 degree to "
            "the picture's plane, and rounding shows"},
        BadShot{"BackgroundOfTwoNumbers", "[image]\nbackground = [0.1, 0.2]",
                "2:14: background must be \"none\", a scene-linear colour [red, green, blue], or two of them: [top, "
                "bottom]"},
        BadShot{"BackgroundOfAnotherName", "[image]\nbackground = \"blue\"",
                "2:14: background must be \"none\", a scene-linear colour [red, green, blue], or two of them: [top, "
                "bottom]"},
        BadShot{"BackgroundOfThreeColours", "[image]\nbackground = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]",
                "2:15: background is an array; a number is needed"},
        BadShot{"BackgroundOfNoNumber", "[image]\nbackground = [nan, 0, 0]",
                "2:15: background is nan; a number is needed"},
        BadShot{"BackgroundBelowZero", "[image]\nbackground = [[0, 0, 0], [0, -1, 0]]",
                "2:30: background holds -1; 0 or more is needed"},
        BadShot{"BackgroundBeyondHalf", "[image]\nbackground = [0, 0, 65505]",
                "2:14: background is 65505; 65504 is the most that half holds"},
        BadShot{"UnknownFit", "[camera]\nprojection = \"frustum\"\nfit = \"wide\"",
                "3:7: unknown fit \"wide\"; did you mean \"widen\"?"},
        BadShot{"UnknownView", "[camera]\nview = \"side\"",
                "2:8: there is no view \"side\"; views are three_quarter, front, back, left, right, top, bottom"},
        BadShot{"DirectionOfNothing", "[camera]\ndirection = [0, 0, 0]",
                "2:13: direction is [0, 0, 0]; it must point from the target to the eye"},
        BadShot{"DirectionAndEye", "[camera]\ndirection = [0, 0, 1]\neye = [0, 5, 0]",
                "3:7: direction says where the camera stands; eye must not be given"},
        BadShot{"DirectionAndView", "[camera]\nview = \"top\"\ndirection = [0, 0, 1]",
                "3:13: view says where the camera stands; direction must not be given"},
        BadShot{"ViewAndEye", "[camera]\nview = \"top\"\neye = [0, 5, 0]",
                "3:7: view says where the camera stands; eye must not be given"},
        BadShot{"DistanceWithoutAView", "[camera]\ndistance = 5",
                "2:12: distance belongs to view and to axonometric projections; here eye says where the camera stands"},
        BadShot{"DistanceLost", "[camera]\nview = \"top\"\ntarget = [0, 1e20, 0]\ndistance = 1",
                "4:12: distance is 1: too small beside the target"},
        BadShot{"TrackOfAView", "[camera]\nview = \"top\"\n[[camera.track]]\ntarget = \"eye\"\nkeys = [[0, [1, 2, 3]]]",
                "4:10: eye cannot move a camera that is placed by its view; give eye, target and up"},
        BadShot{"DimetricOfThreeRatios", "[camera]\nprojection = \"dimetric\"\nratios = [1, 0.9, 0.5]",
                "3:10: the ratios of a dimetric projection must have two equal ones; trimetric takes any"},
        BadShot{"DimetricThatIsIsometric", "[camera]\nprojection = \"dimetric\"\nratios = [1, 1, 1]",
                "3:10: the ratios of a dimetric projection must have a different one; isometric has three equal"},
        BadShot{"RatiosOfNoView", "[camera]\nprojection = \"trimetric\"\nratios = [1, 0.5, 0.5]",
                "1:1: ratios are (1, 0.5, 0.5); each must be 0 or more, and the square of none more than those of the "
                "other two together"},
        BadShot{"TrimetricOfNothing", "[camera]\nprojection = \"trimetric\"",
                "1:1: a trimetric projection needs ratios, axis_angles_degrees, or azimuth_degrees and "
                "elevation_degrees"},
        BadShot{"TrimetricOfOneAngle", "[camera]\nprojection = \"trimetric\"\nazimuth_degrees = 30",
                "1:1: camera needs the key \"elevation_degrees\""},
        BadShot{
            "AxisAnglesOfNoView", "[camera]\nprojection = \"trimetric\"\naxis_angles_degrees = [45, 45]",
            "1:1: the axes' angles are 45 and 45 degrees; each must be 0 or more, and their sum above 0 and below 90"},
        BadShot{"CornerOfTwos", "[camera]\nprojection = \"isometric\"\ncorner = [1, 2, 1]",
                "3:10: corner is (1, 2, 1); each number must be 1 or -1"}),
    bad_shot_name);

INSTANTIATE_TEST_SUITE_P(
    Light, WrongShot,
    ::testing::Values(
        BadShot{"Neither", "[[light]]\ncolor = [1, 1, 1]", "1:1: a light needs either a direction or a position"},
        BadShot{"Both", "[[light]]\ndirection = [0, 0, 1]\nposition = [0, 0, 1]",
                "1:1: a light needs either a direction or a position"},
        BadShot{"NoDirection", "[[light]]\ndirection = [0, 0, 0]",
                "2:13: direction is [0, 0, 0]; it must point from the scene towards the light"},
        BadShot{"NegativeColor", "[[light]]\ndirection = [0, 0, 1]\ncolor = [1, -0.5, 1]",
                "3:13: color holds -0.5; 0 or more is needed"},
        BadShot{"NegativeIntensity", "[[light]]\ndirection = [0, 0, 1]\nintensity = -1",
                "3:13: intensity is -1; 0 or more is needed"},
        BadShot{"FalloffOfADirection", "[[light]]\ndirection = [0, 0, 1]\nfalloff = true",
                "3:11: only a light with a position falls off with distance"},
        BadShot{"TrackOfTheOtherKind",
                "[[light]]\ndirection = [0, 0, 1]\n[[light.track]]\ntarget = \"position\"\nkeys = [[0, [0, 0, 1]]]",
                "4:10: a light has no value \"position\" to move; known: direction, color"},
        BadShot{"AmbientOfTwo", "ambient = [0.1, 0.1]", "1:11: ambient must be three numbers: [red, green, blue]"}),
    bad_shot_name);

}  // namespace
}  // namespace morphcl
