// A renderer for tests of jobs: its pixels depend on the frame number alone, and it notes what it was asked for.
#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/job.hpp"
#include "tests/image/test_frames.hpp"

namespace morphcl::job_test {

constexpr int width = 24, height = 10;

inline FrameBuffer pixels_of(std::int64_t frame) {
  return image_test::arbitrary_frame(width, height, default_channels, static_cast<std::uint64_t>(frame));
}

class FakeRenderer : public Renderer {
 public:
  std::vector<std::int64_t> rendered;                   // in the order of the calls
  std::set<const FrameBuffer*> buffers;                 // that were handed in
  std::function<void(std::int64_t frame)> before_draw;  // may throw

  std::string deviates;  // what deviation() returns

  std::string name() const override { return "fake"; }
  std::string deviation() const override { return deviates; }

 private:
  void draw(const FramePlan& plan, FrameBuffer& frame) override {
    rendered.push_back(plan.frame);
    buffers.insert(&frame);
    if (before_draw) before_draw(plan.frame);
    const FrameBuffer pixels = pixels_of(plan.frame);
    std::copy_n(pixels.data(), pixels.bytes(), frame.data());
  }
};

inline Scene empty_scene() {
  Scene scene;
  scene.image.width = width;
  scene.image.height = height;
  scene.image.compression = "rle";
  scene.content_hash = "content";
  return scene;
}

// Several frames side by side, whatever machine the test runs on. What the fake renderer draws is not what is planned,
// so equal plans say nothing.
inline RenderJob job_of(const std::string& pattern, std::vector<std::int64_t> frames) {
  RenderJob job;
  job.pattern = pattern;
  job.frames = std::move(frames);
  job.threads = 2;
  job.reuse_equal_frames = false;
  return job;
}

}  // namespace morphcl::job_test
