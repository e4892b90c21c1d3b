// Jobs whose frames are PNG files: the same promises as for EXR.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "morphcl/error.hpp"
#include "morphcl/png.hpp"
#include "tests/job/fake_renderer.hpp"
#include "tests/job/frame_lists.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace job_test;
using test_support::bytes_of;
using test_support::TemporaryFolder;
using Status = FrameResult::Status;

void expect_whole_png(const FrameResult& result, int bits) {
  const PngDescription read = describe_png(result.path);
  EXPECT_EQ(read.bits, bits);
  EXPECT_EQ(read.hash, result.hash) << "frame " << result.frame;
  EXPECT_EQ(read.stored_hash, result.hash) << "frame " << result.frame;
  EXPECT_EQ(read.attributes.frame, result.frame);
  EXPECT_EQ(read.attributes.fingerprint, fingerprint(empty_scene()));
}

TEST(PngJobs, WriteTheColoursOfEveryFrame) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  for (const int bits : {8, 16}) {
    RenderJob job = job_of(folder / ("a." + std::to_string(bits) + ".##.PNG"), {5, 2, -3});
    job.sample_bits = bits;
    job.verify = true;
    const JobResult result = run(job, empty_scene(), renderer);
    EXPECT_EQ(frames_of(result, Status::rendered), (std::vector<std::int64_t>{-3, 2, 5}));
    for (const FrameResult& frame : result.frames) expect_whole_png(frame, bits);
    TemporaryFolder other;
    EXPECT_EQ(write_png(other / "b.png", pixels_of(2), {}, bits), result.frames[1].hash);
  }
  EXPECT_EQ(folder.names().size(), 6u);
}

TEST(PngJobs, ResumeRendersExactlyWhatIsMissingOrDamaged) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.##.png", range(0, 7));
  FakeRenderer first, second, third;
  const JobResult before = run(job, empty_scene(), first);
  std::filesystem::remove(folder / "a.02.png");
  std::vector<char> bytes = bytes_of(folder / "a.04.png");
  test_support::write_bytes(folder / "a.04.png", {bytes.begin(), bytes.begin() + bytes.size() * 6 / 10});
  bytes = bytes_of(folder / "a.05.png");
  bytes[bytes.size() - 40] = static_cast<char>(bytes[bytes.size() - 40] ^ 4);
  test_support::write_bytes(folder / "a.05.png", bytes);

  job.resume = true;
  const JobResult after = run(job, empty_scene(), second);
  EXPECT_EQ(second.rendered, (std::vector<std::int64_t>{2, 4, 5}));
  EXPECT_EQ(frames_of(after, Status::kept), (std::vector<std::int64_t>{0, 1, 3, 6, 7}));
  for (std::size_t i = 0; i < after.frames.size(); ++i) EXPECT_EQ(after.frames[i].hash, before.frames[i].hash);
  job.sample_bits = 16;
  EXPECT_EQ(frames_of(run(job, empty_scene(), third), Status::rendered), range(0, 7)) << "those have 8 bits";
}

TEST(PngJobs, ResumeTellsExposuresApart) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.##.png", range(0, 2));
  FakeRenderer first, second, third;
  const JobResult plain = run(job, empty_scene(), first);
  job.resume = true;
  job.exposure_stops = -1.5;
  const JobResult darker = run(job, empty_scene(), second);
  EXPECT_EQ(frames_of(darker, Status::rendered), range(0, 2));
  EXPECT_NE(darker.frames[1].hash, plain.frames[1].hash);
  EXPECT_EQ(frames_of(run(job, empty_scene(), third), Status::kept), range(0, 2));
}

TEST(PngJobs, AnExposureDoesNotTouchExrFrames) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.##.exr", range(0, 1));
  FakeRenderer first, second;
  run(job, empty_scene(), first);
  job.resume = true;
  job.exposure_stops = 2;
  job.contact_sheet = folder / "bright.png";
  EXPECT_EQ(frames_of(run(job, empty_scene(), second), Status::kept), range(0, 1));
  job.exposure_stops = 0;
  job.contact_sheet = folder / "plain.png";
  run(job, empty_scene(), second);
  EXPECT_NE(describe_png(folder / "bright.png").hash + std::to_string(bytes_of(folder / "bright.png").size()),
            describe_png(folder / "plain.png").hash + std::to_string(bytes_of(folder / "plain.png").size()));
}

TEST(PngJobs, ExposuresOutOfRangeAreRefused) {
  const TemporaryFolder folder;
  for (const double wrong : {31.0, -30.5, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    RenderJob job = job_of(folder / "a.##.png", {1});
    job.exposure_stops = wrong;
    FakeRenderer renderer;
    EXPECT_THROW(run(job, empty_scene(), renderer), Error) << wrong;
    EXPECT_TRUE(renderer.rendered.empty());
  }
}

TEST(PngJobs, ResumeLooksAtTheFramesNumber) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.##.png", {1, 2, 3});
  FakeRenderer first, second;
  run(job, empty_scene(), first);
  std::filesystem::copy_file(folder / "a.01.png", folder / "a.03.png",
                             std::filesystem::copy_options::overwrite_existing);
  job.resume = true;
  const JobResult result = run(job, empty_scene(), second);
  EXPECT_EQ(second.rendered, std::vector<std::int64_t>{3});
  for (const FrameResult& frame : result.frames) expect_whole_png(frame, 8);
}

TEST(PngJobs, FramesWithTheSamePictureAreCopied) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  RenderJob job = job_of(folder / "a.##.png", range(98, 101));
  job.reuse_equal_frames = true;  // an empty scene never changes
  const JobResult result = run(job, empty_scene(), renderer);
  EXPECT_EQ(frames_of(result, Status::copied), range(99, 101));
  for (const FrameResult& frame : result.frames) expect_whole_png(frame, 8);
  EXPECT_EQ(result.frames[3].hash, result.frames[0].hash);
}

TEST(PngJobs, SheetsShowRenderedCopiedAndKeptFramesAlike) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  RenderJob job = job_of(folder / "a.##.png", range(0, 5));
  job.contact_sheet = folder / "sheet.png";
  run(job, empty_scene(), renderer);
  const std::vector<char> sheet = bytes_of(folder / "sheet.png");
  std::filesystem::remove(folder / "a.04.png");
  job.resume = true;
  EXPECT_EQ(frames_of(run(job, empty_scene(), renderer), Status::rendered), std::vector<std::int64_t>{4});
  EXPECT_EQ(bytes_of(folder / "sheet.png"), sheet);
}

TEST(PngJobs, WhatDoesNotGoWithTheFormatIsRefusedBeforeAnythingIsRendered) {
  const TemporaryFolder folder;
  const auto refused = [](const RenderJob& job, const Scene& scene) {
    FakeRenderer renderer;
    try {
      run(job, scene, renderer);
    } catch (const Error& error) {
      EXPECT_TRUE(renderer.rendered.empty());
      EXPECT_EQ(error.kind(), ErrorKind::usage) << error.what();
      return true;
    }
    return false;
  };
  RenderJob job = job_of(folder / "a.##.png", {1, 2});
  job.sample_bits = 12;
  EXPECT_TRUE(refused(job, empty_scene()));
  job.sample_bits = 8;
  job.preview = true;
  EXPECT_TRUE(refused(job, empty_scene()));
  job.preview = false;
  Scene depth_alone = empty_scene();
  depth_alone.image.channels.erase(Channel::color);
  EXPECT_TRUE(refused(job, depth_alone));
  job.pattern = folder / "a.##.exr";
  job.sample_bits = 16;
  EXPECT_TRUE(refused(job, empty_scene()));
  for (const char* name : {"a.##.mp4", "a.##.jpg", "a.##"})
    EXPECT_TRUE(refused(job_of(folder / name, {1, 2}), empty_scene()));
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace morphcl
