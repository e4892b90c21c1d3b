// Frames with the same picture are drawn once: the others are copies with their own number, and nothing tells them from
// drawn ones but the time they took.
#include "host/job/equal_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/job/fake_renderer.hpp"
#include "tests/job/frame_lists.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace job_test;
using test_support::bytes_of;
using test_support::TemporaryFolder;
using Status = FrameResult::Status;

// What the plan says, by the reference renderer, which is asked for every picture here.
class NotingRenderer : public Renderer {
 public:
  std::vector<std::int64_t> rendered;
  std::function<void(std::int64_t frame)> before_draw;  // may throw

  std::string name() const override { return "noting"; }

 private:
  void draw(const FramePlan& plan, FrameBuffer& frame) override {
    rendered.push_back(plan.frame);
    if (before_draw) before_draw(plan.frame);
    renderer_->render(Plan(plan), frame);
  }

  std::unique_ptr<Renderer> renderer_ = make_reference_renderer();
};

// A pyramid that becomes a cube in frames 0 to 10 and a pyramid again in frames 10 to 20.
Scene ping_pong() {
  Scene scene;
  scene.image.width = 80;
  scene.image.height = 50;
  scene.frames = {{.first = 0, .last = 20}};
  scene.meshes = {make_solid("pyramid_to_cube")};
  scene.objects.emplace_back().name = "solid";
  scene.timeline.nodes.emplace_back().translation = {-100, -100, -65};
  scene.timeline.camera.eye = {200, 150, 400};
  scene.timeline.camera.projection = Perspective{45, 1, 2000};
  scene.timeline.lights.emplace_back().vector = {0.4, 0.7, 0.9};
  const TimeBase time = scene.timeline.time;
  const Track there_and_back({Interpolation::linear,
                              1,
                              false,
                              time.ticks_per_second(),
                              {time.frame_ticks(0), time.frame_ticks(10), time.frame_ticks(20)},
                              {0, 1, 0}});
  scene.objects[0].morph = {.weights = {0}, .tracks = {{.first_target = 0, .track = there_and_back}}};
  validate(scene);
  return scene;
}

Scene still() {
  Scene scene = ping_pong();
  scene.objects[0].morph = {.weights = {0.5}, .tracks = {}};
  return scene;
}

RenderJob copying_job(const std::string& pattern, std::vector<std::int64_t> frames) {
  RenderJob job = job_of(pattern, std::move(frames));
  job.reuse_equal_frames = true;
  return job;
}

TEST(EqualFrames, TheWayBackIsCopiedAndHasTheBytesOfDrawnFrames) {
  for (const char* compression : {"zip", "rle", "dwaa", "zip rounded"}) {
    SCOPED_TRACE(compression);
    const TemporaryFolder folder;
    Scene scene = ping_pong();
    scene.image.compression = std::string(compression).substr(0, std::string(compression).find(' '));
    if (std::string(compression).ends_with("rounded")) scene.image.z_error = 1e-5;
    NotingRenderer copying, drawing;
    const JobResult copied = run(copying_job(folder / "a.##.exr", range(0, 20)), scene, copying);
    RenderJob job = copying_job(folder / "b.##.exr", range(0, 20));
    job.reuse_equal_frames = false;
    const JobResult drawn = run(job, scene, drawing);
    EXPECT_EQ(copying.rendered, range(0, 10));
    EXPECT_EQ(frames_of(copied, Status::rendered), range(0, 10));
    EXPECT_EQ(frames_of(copied, Status::copied), range(11, 20));
    EXPECT_EQ(drawing.rendered, range(0, 20));
    ASSERT_EQ(copied.frames.size(), drawn.frames.size());
    for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
      EXPECT_EQ(copied.frames[i].hash, drawn.frames[i].hash) << "frame " << i;
      EXPECT_EQ(bytes_of(copied.frames[i].path), bytes_of(drawn.frames[i].path)) << "frame " << i;
      EXPECT_TRUE(is_finished_frame(copied.frames[i].path, fingerprint(scene))) << "frame " << i;
    }
    EXPECT_NE(copied.frames[3].hash, copied.frames[4].hash);
  }
}

TEST(EqualFrames, CopiesAreVerifiedAndHavePictures) {
  const TemporaryFolder folder;
  const Scene scene = ping_pong();
  const auto pictures = [&](const std::string& name, bool reuse) {
    NotingRenderer renderer;
    RenderJob job = copying_job(folder / (name + ".##.exr"), {2, 18, 9, 11});
    job.reuse_equal_frames = reuse;
    job.verify = job.preview = true;
    job.contact_sheet = folder / (name + ".png");
    run(job, scene, renderer);
    EXPECT_EQ(renderer.rendered.size(), reuse ? 2u : 4u);
    std::vector<std::vector<char>> files{bytes_of(job.contact_sheet)};
    for (const char* frame : {".02.png", ".09.png", ".11.png", ".18.png"})
      files.push_back(bytes_of(folder / (name + frame)));
    return files;
  };
  EXPECT_EQ(pictures("a", true), pictures("b", false));
}

TEST(EqualFrames, StillShotIsDrawnOnce) {
  const TemporaryFolder folder;
  const Scene scene = still();
  for (const int threads : {1, 4}) {
    NotingRenderer renderer;
    RenderJob job = copying_job(folder / "a.###.exr", range(0, 39));
    job.threads = threads;
    EXPECT_EQ(frames_of(run(job, scene, renderer), Status::copied), range(1, 39));
    EXPECT_EQ(renderer.rendered, range(0, 0));
  }
  EXPECT_EQ(read_exr(folder / "a.037.exr").attributes.frame, 37);
}

// Deleted or overwritten: what cannot be copied any more is drawn, and later frames are copied from that one.
TEST(EqualFrames, SourceThatGoesWhileTheJobRunsIsDrawnAgain) {
  for (const bool overwrite : {false, true}) {
    const TemporaryFolder folder;
    const Scene scene = still();
    NotingRenderer renderer;
    RenderJob job = copying_job(folder / "a.##.exr", range(0, 40));
    bool gone = false;
    job.on_frame = [&](const FrameResult& result) {
      if (result.frame != 5) return;  // some copies have been made
      std::vector<char> bytes = bytes_of(folder / "a.00.exr");
      std::filesystem::remove(folder / "a.00.exr");
      for (std::size_t i = bytes.size() - 200; i < bytes.size() - 100; ++i) bytes[i] = static_cast<char>(~bytes[i]);
      if (overwrite) test_support::write_bytes(folder / "a.00.exr", bytes);
      gone = true;
    };
    const JobResult result = run(job, scene, renderer);
    EXPECT_TRUE(gone);
    EXPECT_EQ(result.frames.size(), 41u);
    // A file that is gone at the end is missing; one that was overwritten is the next run's to find.
    EXPECT_EQ(frames_of(result, Status::failed), overwrite ? std::vector<std::int64_t>{} : range(0, 0));
    EXPECT_GE(renderer.rendered.size(), 2u) << "the lost frame's picture was not drawn again";
    EXPECT_LE(renderer.rendered.size(), 30u) << "the picture drawn again is no source of copies";
    for (const FrameResult& frame : result.frames) {
      EXPECT_EQ(frame.hash, result.frames[0].hash) << "frame " << frame.frame;
      EXPECT_EQ(is_finished_frame(frame.path, fingerprint(scene)), frame.frame != 0) << "frame " << frame.frame;
    }
  }
}

TEST(EqualFrames, FailedFramesHaveNoCopies) {
  const TemporaryFolder folder;
  const Scene scene = ping_pong();
  NotingRenderer renderer;
  renderer.before_draw = [](std::int64_t frame) {
    if (frame == 4) throw Error(ErrorKind::no_device, "", "the device is gone");
  };
  const JobResult result = run(copying_job(folder / "a.##.exr", range(0, 20)), scene, renderer);
  EXPECT_EQ(frames_of(result, Status::failed), range(4, 4));
  EXPECT_EQ(frames_of(result, Status::rendered), (std::vector<std::int64_t>{0, 1, 2, 3, 5, 6, 7, 8, 9, 10, 16}));
  EXPECT_TRUE(is_finished_frame(folder / "a.16.exr", fingerprint(scene)));
}

TEST(EqualFrames, FramesThatCouldNotBeWrittenHaveNoCopies) {
  const TemporaryFolder folder;
  const Scene scene = still();
  std::filesystem::create_directory(folder / "a.00.exr");  // stands where the first frame belongs
  NotingRenderer renderer;
  const JobResult result = run(copying_job(folder / "a.##.exr", {1, 0, 2}), scene, renderer);
  EXPECT_EQ(frames_of(result, Status::failed), range(0, 0));
  NotingRenderer second;
  const JobResult other = run(copying_job(folder / "a.##.exr", {3, 0, 4}), scene, second);
  EXPECT_EQ(frames_of(other, Status::copied), range(4, 4));
  EXPECT_EQ(frames_of(other, Status::failed), range(0, 0));
}

TEST(EqualFrames, StopFinishesTheCopiesThatWereReached) {
  const TemporaryFolder folder;
  const Scene scene = still();
  NotingRenderer renderer;
  std::atomic<bool> stop{false};
  RenderJob job = copying_job(folder / "a.####.exr", range(0, 5000));
  job.stop = &stop;
  job.on_frame = [&](const FrameResult& result) { stop = stop || result.frame == 20; };
  const JobResult result = run(job, scene, renderer);
  EXPECT_TRUE(result.interrupted);
  EXPECT_LT(result.frames.size(), 100u) << "the queue of copies has no bound";
  for (const FrameResult& frame : result.frames) EXPECT_TRUE(is_finished_frame(frame.path, fingerprint(scene)));
}

TEST(EqualFrames, ResumedJobsCopyToo) {
  const TemporaryFolder folder;
  const Scene scene = ping_pong();
  NotingRenderer first, second;
  RenderJob job = copying_job(folder / "a.##.exr", range(0, 20));
  const JobResult before = run(job, scene, first);
  for (const char* name : {"a.03.exr", "a.17.exr", "a.12.exr"}) std::filesystem::remove(folder / name);
  job.resume = true;
  const JobResult after = run(job, scene, second);
  EXPECT_EQ(second.rendered, (std::vector<std::int64_t>{3, 12}));
  EXPECT_EQ(frames_of(after, Status::copied), range(17, 17));
  for (std::size_t i = 0; i < after.frames.size(); ++i) EXPECT_EQ(after.frames[i].hash, before.frames[i].hash);
}

PlanDigest digest_of(std::uint64_t i) { return {i, ~i}; }

TEST(EqualFrames, PictureIsClaimedAgainAfterItsFrameFailed) {
  EqualFrames frames;
  auto first = std::get<WrittenFramePromise>(frames.find_or_claim(digest_of(1)));
  EXPECT_TRUE(std::holds_alternative<WrittenFrameFuture>(frames.find_or_claim(digest_of(1)))) << "is being written";
  first.set_value({});
  auto second = std::get<WrittenFramePromise>(frames.find_or_claim(digest_of(1)));
  second = {};  // given up
  auto third = std::get<WrittenFramePromise>(frames.find_or_claim(digest_of(1)));
  third.set_value({7, 1000, "hash"});
  EXPECT_EQ(std::get<WrittenFrameFuture>(frames.find_or_claim(digest_of(1))).get().frame, 7);
}

TEST(EqualFrames, PicturesInMemoryAreBounded) {
  EqualFrames frames;
  std::vector<WrittenFramePromise> promises;
  for (std::uint64_t i = 0; i <= EqualFrames::max_frames; ++i)
    promises.push_back(std::get<WrittenFramePromise>(frames.find_or_claim(digest_of(i))));
  EXPECT_TRUE(std::holds_alternative<WrittenFrameFuture>(frames.find_or_claim(digest_of(EqualFrames::max_frames))));
  EXPECT_TRUE(std::holds_alternative<WrittenFrameFuture>(frames.find_or_claim(digest_of(1))));
  EXPECT_TRUE(std::holds_alternative<WrittenFramePromise>(frames.find_or_claim(digest_of(0)))) << "the oldest one";
}

}  // namespace
}  // namespace morphcl
