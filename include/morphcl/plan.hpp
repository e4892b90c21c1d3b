// The plan of a frame: what a planner (planner.hpp) found has to be drawn, and what a renderer (renderer.hpp) draws.
#pragma once

#include <cstdint>
#include <memory>

#include "morphcl/exr.hpp"
#include "morphcl/frame.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

struct FramePlan;  // the plan itself; complete within the library alone

// Copies are cheap: they share the plan, which never changes. It refers to the meshes of its scene, which has to
// outlive it and must not change meanwhile.
class Plan {
 public:
  explicit Plan(FramePlan plan);

  std::int64_t frame() const;
  int width() const;  // pixels
  int height() const;
  ChannelSet channels() const;

  // A frame to draw it into; one frame does for all plans of a scene.
  FrameBuffer make_frame() const;
  // What a file of the frame says about it: number, rate, camera. The fingerprint is empty.
  FrameAttributes attributes() const;

  // For the library alone, where FramePlan is complete. On a temporary plan operator* returns a copy.
  const FramePlan& operator*() const& { return *plan_; }
  FramePlan operator*() &&;
  const FramePlan* operator->() const& { return plan_.get(); }
  const FramePlan* operator->() && = delete;

 private:
  std::shared_ptr<const FramePlan> plan_;
};

}  // namespace morphcl
#pragma GCC visibility pop
