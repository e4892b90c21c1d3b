// What endings of output patterns ask for, and what is said about those that ask for nothing that can be written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "morphcl/error.hpp"
#include "morphcl/job.hpp"

namespace morphcl {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(FrameFormats, AreThoseOfTheEndingInAnyCase) {
  for (const char* pattern : {"a.exr", "out.png/a.####.exr", "a.%04d.EXR", ".exr", "a.png.#.Exr"})
    EXPECT_EQ(frame_format(pattern), FrameFormat::exr) << pattern;
  for (const char* pattern : {"a.png", "out.exr/a.####.png", "a.%04d.PNG", "####.pNg", "a.exr.#.png"})
    EXPECT_EQ(frame_format(pattern), FrameFormat::png) << pattern;
}

std::string format_refusal(const std::string& pattern) {
  try {
    frame_format(pattern);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.message(), HasSubstr("'" + pattern + "'"));
    EXPECT_THAT(error.message(), Not(HasSubstr("\n")));
    return error.message();
  }
  ADD_FAILURE() << pattern << " was taken";
  return "";
}

TEST(FrameFormats, OfVideosAreFramesForAnotherTool) {
  for (const char* ending : {".mp4", ".mov", ".webm", ".gif", ".mkv", ".avi", ".MP4"}) {
    const std::string message = format_refusal("out/film" + std::string(ending));
    EXPECT_THAT(message, HasSubstr("'out/film.####.png'"));
    EXPECT_THAT(message, HasSubstr("ffmpeg"));
  }
  EXPECT_THAT(format_refusal("film.%03d.mp4"), HasSubstr("'film.%03d.png'"));
}

TEST(FrameFormats, OfOtherPicturesAreNamed) {
  for (const char* ending : {".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp", ".JPG", ".hdr", ".txt", ".exr2"}) {
    const std::string message = format_refusal("a.####" + std::string(ending));
    EXPECT_THAT(message, HasSubstr("'a.####.exr' or 'a.####.png'"));
    EXPECT_THAT(message, HasSubstr("ends in " + std::string(ending)));
  }
}

TEST(FrameFormats, WithoutAnEndingOneIsAskedFor) {
  EXPECT_THAT(format_refusal("film"), HasSubstr("'film.####.exr'"));
  EXPECT_THAT(format_refusal("film."), HasSubstr("'film.####.png'"));
  EXPECT_THAT(format_refusal("film.####"), HasSubstr("'film.####.png'"));
  EXPECT_THAT(format_refusal("film.exr.%04d"), HasSubstr("'film.exr.%04d.exr'"));
  EXPECT_THAT(format_refusal("out.exr/"), HasSubstr("no file name"));
  EXPECT_THAT(format_refusal("out.exr/film"), HasSubstr("'out.exr/film.####.exr'"));
}

}  // namespace
}  // namespace morphcl
