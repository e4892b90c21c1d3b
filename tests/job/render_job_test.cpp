#include "morphcl/job.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "tests/job/fake_renderer.hpp"
#include "tests/job/frame_lists.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace job_test;
using test_support::bytes_of;
using test_support::TemporaryFolder;
using Status = FrameResult::Status;

void expect_whole(const FrameResult& result) {
  const ExrFrame read = read_exr(result.path);
  EXPECT_EQ(image_test::difference(pixels_of(result.frame), read.frame), "") << "frame " << result.frame;
  EXPECT_EQ(read.hash, result.hash) << "frame " << result.frame;
  EXPECT_EQ(read.stored_hash, result.hash) << "frame " << result.frame;
}

std::vector<std::int64_t> replaced_frames(const JobResult& result) {
  std::vector<std::int64_t> frames;
  for (const FrameResult& frame : result.frames)
    if (frame.replaced) frames.push_back(frame.frame);
  return frames;
}

ErrorKind kind_of_failure(const RenderJob& job, const Scene& scene = empty_scene()) {
  FakeRenderer renderer;
  try {
    run(job, scene, renderer);
  } catch (const Error& error) {
    EXPECT_TRUE(renderer.rendered.empty()) << "something was rendered before: " << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "the job ran";
  return ErrorKind::internal;
}

TEST(RenderJob, WritesEveryFrameAndAnswersInAscendingOrder) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  const JobResult result = run(job_of(folder / "a.####.exr", {5, 2, 9, -3}), empty_scene(), renderer);
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(frames_of(result, Status::rendered), (std::vector<std::int64_t>{-3, 2, 5, 9}));
  EXPECT_EQ(renderer.rendered, (std::vector<std::int64_t>{5, 2, 9, -3}));
  for (const FrameResult& frame : result.frames) expect_whole(frame);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"a.-003.exr", "a.0002.exr", "a.0005.exr", "a.0009.exr"}));
}

// Two devices that round differently, and one that does not, never share a sequence.
TEST(RenderJob, FramesOfARendererThatDeviatesSayHowAndAreNotMixedWithOthers) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.####.exr", {1, 2});
  job.resume = true;
  const auto kept_of = [&](const std::string& deviation) {
    FakeRenderer renderer;
    renderer.deviates = deviation;
    const JobResult result = run(job, empty_scene(), renderer);
    for (const FrameResult& frame : result.frames)
      EXPECT_EQ(read_exr(frame.path).attributes.deviation, deviation) << frame.path;
    return frames_of(result, Status::kept).size();
  };
  EXPECT_EQ(kept_of(""), 0u);
  EXPECT_EQ(kept_of(""), 2u);
  EXPECT_EQ(kept_of("device, driver 1: a/b, at most 1 ulp"), 0u);
  EXPECT_EQ(kept_of("device, driver 1: a/b, at most 1 ulp"), 2u);
  EXPECT_EQ(kept_of("device, driver 2: a/b, at most 2 ulp"), 0u);
  EXPECT_EQ(kept_of(""), 0u);
}

TEST(RenderJob, ANameThatIsTooLongIsFoundBeforeAnythingIsDrawn) {
  const TemporaryFolder folder;
  const std::string long_name(247, 'n');  // with ".0001" and ".exr" one more than file systems take
  EXPECT_EQ(kind_of_failure(job_of(folder / (long_name + ".####.exr"), {1})), ErrorKind::cannot_create);
  EXPECT_EQ(kind_of_failure(job_of(folder / (long_name.substr(1) + ".####.exr"), {1, 10000})),
            ErrorKind::cannot_create);
  RenderJob job = job_of(folder / (long_name.substr(1) + ".####.png"), {1, 10000});
  EXPECT_EQ(kind_of_failure(job), ErrorKind::cannot_create);
  job = job_of(folder / "a.####.exr", {1});
  job.contact_sheet = folder / (long_name + "123456789.png");
  EXPECT_EQ(kind_of_failure(job), ErrorKind::cannot_create);
  EXPECT_TRUE(folder.names().empty());
}

TEST(RenderJob, AnOutputThatIsAnInputOrAnotherOutputIsRefused) {
  const TemporaryFolder folder;
  Scene scene = empty_scene();
  scene.inputs = {folder.write("shot.toml", "shot"), folder.write("sky.exr", "sky"),
                  folder.write("skin.0002.png", "skin")};
  std::filesystem::create_directory_symlink(folder.path(), folder / "link");
  std::filesystem::create_symlink("sky.exr", folder / "other.exr");
  const std::string detour = "link/../" + folder.path().filename().string() + "/sky.exr";
  for (const std::string& pattern : {std::string("sky.exr"), std::string("link/sky.exr"), detour})
    EXPECT_EQ(kind_of_failure(job_of(folder / pattern, {1}), scene), ErrorKind::usage) << pattern;
  EXPECT_EQ(kind_of_failure(job_of(folder / "skin.####.png", {1, 2, 3}), scene), ErrorKind::usage);
  RenderJob job = job_of(folder / "a.####.exr", {1, 2});
  for (const std::string sheet : {"shot.toml", "a.0002.exr", "link/a.0001.exr"}) {
    job.contact_sheet = folder / sheet;
    EXPECT_EQ(kind_of_failure(job, scene), ErrorKind::usage) << sheet;
  }
  job.preview = true;
  job.contact_sheet = folder / "a.0002.png";
  EXPECT_EQ(kind_of_failure(job, scene), ErrorKind::usage);
  scene.inputs = {folder / "other.exr"};  // leads to sky.exr
  EXPECT_EQ(kind_of_failure(job_of(folder / "sky.exr", {1}), scene), ErrorKind::usage);
  EXPECT_EQ(test_support::text_of(folder / "sky.exr"), "sky");
  EXPECT_EQ(test_support::text_of(folder / "shot.toml"), "shot");
}

// As on a network file system, or by a hasty hand.
TEST(RenderJob, FramesWhoseFilesAreGoneAtTheEndHaveFailed) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  const RenderJob job = job_of(folder / "out/a.####.exr", {0, 1, 2, 3, 4, 5, 6, 7});
  renderer.before_draw = [&](std::int64_t frame) {
    if (frame != 7) return;
    for (const char* name : {"0000", "0001", "0002", "0003", "0004", "0005", "0006"})
      while (!std::filesystem::exists(folder / ("out/a." + std::string(name) + ".exr"))) std::this_thread::yield();
    std::filesystem::remove_all(folder / "out");
  };
  const JobResult result = run(job, empty_scene(), renderer);
  ASSERT_EQ(result.frames.size(), 8u);
  for (const FrameResult& frame : result.frames) {
    EXPECT_EQ(frame.status, frame.frame == 7 ? Status::rendered : Status::failed) << frame.path;
    EXPECT_EQ(frame.error.empty(), frame.frame == 7);
  }
}

// A file that was copied or renamed to another frame's name.
TEST(RenderJob, ResumeLooksAtTheFramesNumber) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.####.exr", {1, 2, 3});
  FakeRenderer first, second;
  run(job, empty_scene(), first);
  std::filesystem::copy_file(folder / "a.0001.exr", folder / "a.0003.exr",
                             std::filesystem::copy_options::overwrite_existing);
  job.resume = true;
  const JobResult result = run(job, empty_scene(), second);
  EXPECT_EQ(frames_of(result, Status::kept), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(second.rendered, std::vector<std::int64_t>{3});
  for (const FrameResult& frame : result.frames) expect_whole(frame);
}

TEST(RenderJob, FramesCarryNumberRateAndFingerprint) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  Scene scene = empty_scene();
  scene.timeline.time = {24000, 1001};
  const RenderJob job = job_of(folder / "a.##.exr", {4, 5});
  run(job, scene, renderer);
  const FrameAttributes attributes = read_exr(folder / "a.05.exr").attributes;
  EXPECT_EQ(attributes.frame, 5);
  EXPECT_EQ(attributes.fps_numerator, 24000);
  EXPECT_EQ(attributes.fps_denominator, 1001);
  EXPECT_EQ(attributes.fingerprint, fingerprint(scene));
}

// What a file holds is rounded before its hash is taken, so that a reader finds the hash of what it reads.
TEST(RenderJob, DepthIsRoundedInFilesWithinTheErrorAskedFor) {
  for (const char* compression : {"zip", "zip:small", "none", "piz"})
    for (const double error : {1e-6, 1e-3, 1e-8}) {
      const TemporaryFolder folder;
      FakeRenderer renderer;
      Scene scene = empty_scene();
      scene.image.compression = compression;
      scene.image.z_error = error;
      RenderJob job = job_of(folder / "a.##.exr", {4, 5, 6});
      job.verify = true;
      for (const FrameResult& result : run(job, scene, renderer).frames) {
        ASSERT_EQ(result.error, "");
        FrameBuffer expected = pixels_of(result.frame);
        round_depth(expected, error);
        const ExrFrame read = read_exr(result.path);
        EXPECT_EQ(image_test::difference(expected, read.frame), "") << compression << " within " << error;
        EXPECT_EQ(read.hash, pixel_hash(expected));
        EXPECT_EQ(read.stored_hash, read.hash);
        EXPECT_EQ(read.attributes.z_error, error);
        EXPECT_EQ(read.hash == pixel_hash(pixels_of(result.frame)), error == 1e-8) << "1e-8 needs all bits";
      }
    }
}

TEST(RenderJob, ResumesFramesOfTheSameErrorOfDepthAlone) {
  const TemporaryFolder folder;
  Scene scene = empty_scene();
  scene.image.z_error = 1e-4;
  RenderJob job = job_of(folder / "a.##.exr", {1, 2});
  job.resume = true;
  FakeRenderer first, same, other;
  run(job, scene, first);
  EXPECT_EQ(frames_of(run(job, scene, same), Status::kept), (std::vector<std::int64_t>{1, 2}));
  EXPECT_TRUE(same.rendered.empty());
  scene.image.z_error = 0;
  run(job, scene, other);
  EXPECT_EQ(other.rendered, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(read_exr(folder / "a.01.exr").attributes.z_error, 0);
}

TEST(RenderJob, NoFramesAreNoWork) {
  FakeRenderer renderer;
  EXPECT_TRUE(run(job_of("/proc/nope/a.exr", {}), empty_scene(), renderer).frames.empty());
}

TEST(RenderJob, SingleFrameNeedsNoNumber) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  RenderJob job = job_of(folder / "still.exr", {42});
  job.threads = 1;
  expect_whole(run(job, empty_scene(), renderer).frames.at(0));
  EXPECT_EQ(folder.names(), std::set<std::string>{"still.exr"});
}

TEST(RenderJob, BytesDependOnNeitherThreadsNorFramesInFlight) {
  const TemporaryFolder folder;
  const auto bytes = [&](const std::string& name, int threads, int in_flight) {
    FakeRenderer renderer;
    RenderJob job = job_of(folder / (name + ".##.exr"), range(0, 7));
    job.threads = threads;
    job.frames_in_flight = in_flight;
    std::vector<char> all;
    for (const FrameResult& frame : run(job, empty_scene(), renderer).frames) {
      const std::vector<char> file = bytes_of(frame.path);
      all.insert(all.end(), file.begin(), file.end());
    }
    return all;
  };
  const std::vector<char> first = bytes("a", 1, 1);
  EXPECT_EQ(bytes("b", 3, 2), first);
  EXPECT_EQ(bytes("c", 4, 0), first);
}

TEST(RenderJob, FramesInMemoryAreBounded) {
  for (const auto& [threads, in_flight, max] : {std::tuple{4, 1, 1u}, {4, 3, 3u}, {1, 2, 2u}, {3, 0, 4u}}) {
    const TemporaryFolder folder;
    FakeRenderer renderer;
    std::atomic<int> drawn{0}, written{0}, max_at_once{0};
    renderer.before_draw = [&](std::int64_t) { max_at_once = std::max<int>(max_at_once, ++drawn - written); };
    RenderJob job = job_of(folder / "a.##.exr", range(0, 30));
    job.threads = threads;
    job.frames_in_flight = in_flight;
    job.on_frame = [&](const FrameResult&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the renderer is faster and has to wait
      ++written;
    };
    run(job, empty_scene(), renderer);
    EXPECT_LE(renderer.buffers.size(), max) << threads << " threads, " << in_flight << " in flight";
    const int on_their_way = threads + 4;  // encoded, without a buffer
    EXPECT_LE(max_at_once, static_cast<int>(max) + on_their_way)
        << threads << " threads, " << in_flight << " in flight";
    EXPECT_EQ(written, 31);
  }
}

TEST(RenderJob, NextFrameIsDrawnWhileTheLastIsWritten) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  std::mutex mutex;
  std::condition_variable changed;
  bool second_started = false, overlapped = false;
  renderer.before_draw = [&](std::int64_t frame) {
    const std::lock_guard lock(mutex);
    if (frame == 1) second_started = true;
    changed.notify_all();
  };
  RenderJob job = job_of(folder / "a.##.exr", {0, 1});
  job.threads = 1;
  job.frames_in_flight = 2;
  job.on_frame = [&](const FrameResult& result) {
    if (result.frame != 0) return;
    std::unique_lock lock(mutex);
    overlapped = changed.wait_for(lock, std::chrono::seconds(20), [&] { return second_started; });
  };
  run(job, empty_scene(), renderer);
  EXPECT_TRUE(overlapped);
}

TEST(RenderJob, ReportsEveryFrameOnceFromOneThreadAtATime) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  std::multiset<std::int64_t> reported;
  std::atomic<int> inside{0};
  RenderJob job = job_of(folder / "a.##.exr", range(0, 20));
  job.threads = 4;
  job.on_frame = [&](const FrameResult& result) {
    EXPECT_EQ(++inside, 1);
    EXPECT_TRUE(std::filesystem::exists(result.path)) << "reported before it stood";
    reported.insert(result.frame);
    --inside;
  };
  run(job, empty_scene(), renderer);
  const std::vector<std::int64_t> frames = range(0, 20);
  EXPECT_EQ(reported, std::multiset<std::int64_t>(frames.begin(), frames.end()));
}

TEST(RenderJob, ResumeRendersExactlyWhatIsMissingOrDamaged) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.##.exr", range(0, 9));
  FakeRenderer first;
  const JobResult before = run(job, empty_scene(), first);

  std::filesystem::remove(folder / "a.02.exr");
  std::vector<char> bytes = bytes_of(folder / "a.04.exr");
  test_support::write_bytes(folder / "a.04.exr", {bytes.begin(), bytes.begin() + bytes.size() * 6 / 10});
  bytes = bytes_of(folder / "a.05.exr");
  bytes[bytes.size() - 40] = static_cast<char>(bytes[bytes.size() - 40] ^ 4);
  test_support::write_bytes(folder / "a.05.exr", bytes);
  test_support::write_bytes(folder / "a.07.exr", {});

  job.resume = true;
  FakeRenderer second;
  const JobResult after = run(job, empty_scene(), second);
  EXPECT_EQ(second.rendered, (std::vector<std::int64_t>{2, 4, 5, 7}));
  EXPECT_EQ(frames_of(after, Status::rendered), second.rendered);
  EXPECT_EQ(frames_of(after, Status::kept), (std::vector<std::int64_t>{0, 1, 3, 6, 8, 9}));
  EXPECT_EQ(replaced_frames(before), std::vector<std::int64_t>{});
  EXPECT_EQ(replaced_frames(after), (std::vector<std::int64_t>{4, 5, 7})) << "2 was missing";
  ASSERT_EQ(after.frames.size(), before.frames.size());
  for (std::size_t i = 0; i < after.frames.size(); ++i) {
    EXPECT_EQ(after.frames[i].hash, before.frames[i].hash);
    expect_whole(after.frames[i]);
  }
}

TEST(RenderJob, ResumeKeepsNothingOfAnotherJob) {
  const TemporaryFolder folder;
  RenderJob job = job_of(folder / "a.##.exr", range(0, 3));
  FakeRenderer first, second;
  run(job, empty_scene(), first);
  job.resume = true;
  Scene other = empty_scene();
  other.timeline.camera.eye.x += 1;
  const JobResult result = run(job, other, second);
  EXPECT_EQ(second.rendered, range(0, 3));
  EXPECT_EQ(replaced_frames(result), range(0, 3));
}

TEST(RenderJob, WithoutResumeEverythingIsRenderedAgain) {
  const TemporaryFolder folder;
  const RenderJob job = job_of(folder / "a.##.exr", range(0, 3));
  FakeRenderer first, second;
  run(job, empty_scene(), first);
  run(job, empty_scene(), second);
  EXPECT_EQ(second.rendered, range(0, 3));
}

TEST(RenderJob, VerifiedFramesAreWhole) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  RenderJob job = job_of(folder / "a.##.exr", range(0, 3));
  job.verify = true;
  for (const char* compression : {"rle", "dwaa"}) {
    Scene scene = empty_scene();
    scene.image.compression = compression;
    EXPECT_EQ(frames_of(run(job, scene, renderer), Status::rendered), range(0, 3)) << compression;
  }
}

TEST(RenderJob, FailingFramesDoNotStopTheOthers) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  renderer.before_draw = [](std::int64_t frame) {
    if (frame == 2) throw Error(ErrorKind::no_device, "", "the device is gone");
    if (frame == 4) throw std::runtime_error("a defect\nin two lines");
  };
  const JobResult result = run(job_of(folder / "a.##.exr", range(0, 5)), empty_scene(), renderer);
  EXPECT_EQ(frames_of(result, Status::failed), (std::vector<std::int64_t>{2, 4}));
  EXPECT_EQ(frames_of(result, Status::rendered), (std::vector<std::int64_t>{0, 1, 3, 5}));
  EXPECT_EQ(result.frames[2].error, "frame 2: the device is gone");
  EXPECT_EQ(result.frames[2].error_code, 69);
  EXPECT_EQ(result.frames[4].error, "frame 4: a defect in two lines");
  EXPECT_EQ(result.frames[4].error_code, 70);
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(folder.names().size(), 4u);
}

TEST(RenderJob, FailedWritesAreFailedFrames) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit limit = before;
  limit.rlim_cur = 500;  // bytes: less than a header
  const auto handler = signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &limit);
  const JobResult result = run(job_of(folder / "a.##.exr", range(0, 3)), empty_scene(), renderer);
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, handler);
  EXPECT_EQ(frames_of(result, Status::failed), range(0, 3));
  for (const FrameResult& frame : result.frames) EXPECT_EQ(frame.error_code, 74) << frame.error;
  EXPECT_TRUE(folder.names().empty());
}

TEST(RenderJob, StopFinishesWhatWasDrawn) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  std::atomic<bool> stop{false};
  renderer.before_draw = [&](std::int64_t frame) { stop = frame == 3; };
  RenderJob job = job_of(folder / "a.##.exr", range(0, 50));
  job.stop = &stop;
  const JobResult result = run(job, empty_scene(), renderer);
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(frames_of(result, Status::rendered), range(0, 3));
  for (const FrameResult& frame : result.frames) expect_whole(frame);
  EXPECT_EQ(folder.names().size(), 4u);
}

TEST(RenderJob, StopBeforeTheFirstFrameReachesNone) {
  const TemporaryFolder folder;
  for (const bool resume : {false, true}) {
    FakeRenderer renderer;
    const std::atomic<bool> stop{true};
    RenderJob job = job_of(folder / "a.##.exr", range(0, 5));
    job.stop = &stop;
    job.resume = resume;
    const JobResult result = run(job, empty_scene(), renderer);
    EXPECT_TRUE(result.interrupted && result.frames.empty() && renderer.rendered.empty());
  }
}

TEST(RenderJob, StopDuringTheLastFrameInterruptsNothing) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  std::atomic<bool> stop{false};
  renderer.before_draw = [&](std::int64_t frame) { stop = frame == 5; };
  RenderJob job = job_of(folder / "a.##.exr", range(0, 5));
  job.stop = &stop;
  const JobResult result = run(job, empty_scene(), renderer);
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(result.frames.size(), 6u);
}

TEST(RenderJob, WhatTheReportThrowsComesOut) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  RenderJob job = job_of(folder / "a.##.exr", range(0, 200));
  job.on_frame = [](const FrameResult& result) {
    if (result.frame == 1) throw std::domain_error("stop it");
  };
  EXPECT_THROW(run(job, empty_scene(), renderer), std::domain_error);
  EXPECT_LT(renderer.rendered.size(), 201u);
  job.resume = true;
  job.frames = range(0, 1);
  EXPECT_THROW(run(job, empty_scene(), renderer), std::domain_error) << "from a kept frame";
}

TEST(RenderJob, WrongSettingsAreFoundBeforeAnythingIsRendered) {
  const TemporaryFolder folder;
  EXPECT_EQ(kind_of_failure(job_of(folder / "a.exr", range(0, 1))), ErrorKind::usage) << "no number";
  EXPECT_EQ(kind_of_failure(job_of(folder / "a.##.##.exr", {1})), ErrorKind::usage) << "two numbers";
  Scene scene = empty_scene();
  scene.image.compression = "jpeg";
  EXPECT_EQ(kind_of_failure(job_of(folder / "a.##.exr", {1}), scene), ErrorKind::usage);
  scene = empty_scene();
  scene.image.channels.erase(Channel::color);
  RenderJob job = job_of(folder / "a.##.exr", {1});
  job.preview = true;
  EXPECT_EQ(kind_of_failure(job, scene), ErrorKind::usage) << "a picture without colour";
  EXPECT_TRUE(folder.names().empty());
}

TEST(RenderJob, OutputThatCannotBeCreatedIsFoundBeforeAnythingIsRendered) {
  const TemporaryFolder folder;
  test_support::write_bytes(folder / "file", {'x'});
  EXPECT_EQ(kind_of_failure(job_of(folder / "file/a.##.exr", range(0, 3))), ErrorKind::cannot_create);
  EXPECT_EQ(kind_of_failure(job_of("/proc/nope/a.##.exr", range(0, 3))), ErrorKind::cannot_create);
  RenderJob job = job_of(folder / "a.##.exr", range(0, 3));
  job.contact_sheet = folder / "file/sheet.png";
  EXPECT_EQ(kind_of_failure(job), ErrorKind::cannot_create);
}

TEST(RenderJob, PicturesShowRenderedAndKeptFramesAlike) {
  const TemporaryFolder folder;
  FakeRenderer renderer;
  RenderJob job = job_of(folder / "a.##.exr", range(0, 5));
  job.contact_sheet = folder / "sheet.png";
  job.preview = true;
  run(job, empty_scene(), renderer);
  std::set<std::string> names{"sheet.png"};
  for (int frame = 0; frame <= 5; ++frame)
    for (const char* end : {".exr", ".png"}) names.insert("a.0" + std::to_string(frame) + end);
  EXPECT_EQ(folder.names(), names);
  const std::vector<char> sheet = bytes_of(folder / "sheet.png"), preview = bytes_of(folder / "a.03.png");

  for (const char* name : {"sheet.png", "a.03.png", "a.04.exr"}) std::filesystem::remove(folder / name);
  job.resume = true;
  const JobResult result = run(job, empty_scene(), renderer);
  EXPECT_EQ(frames_of(result, Status::rendered), std::vector<std::int64_t>{4});
  EXPECT_EQ(bytes_of(folder / "sheet.png"), sheet);
  EXPECT_EQ(bytes_of(folder / "a.03.png"), preview);
}

}  // namespace
}  // namespace morphcl
