// Renderers turn plans into pixels. Two exist: one that runs OpenCL kernels, and a reference of plain loops, slow and
// short, which defines what the kernels have to compute. They give the same bits on devices with Verdict::identical
// (session.hpp).
//
//   const auto renderer = make_device_renderer(Session::open({}));
//   const Planner planner(scene);
//   FrameBuffer frame = planner.plan(0).make_frame();
//   for (int i = 0; i <= 100; ++i) renderer->render(planner.plan(i), frame);
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "morphcl/frame.hpp"
#include "morphcl/plan.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

class Session;

// For one thread at a time. Not made for classes outside of the library to derive from.
class Renderer {
 public:
  virtual ~Renderer() = default;

  // Draws the planned frame. Blocks until the pixels are in host memory. What plans of one planner share is kept
  // between calls.
  //
  // Error(usage) when `frame` has another size or other channels than the plan, be they too few or too many, and when
  // the plan is of another planner than those before it and forget() was not called: its scene may be another.
  // Error(no_device, internal) when the device failed or has too little memory.
  void render(const Plan& plan, FrameBuffer& frame);

  // What the renderer has drawn so far counts no more: the next plan may be of any planner.
  void forget() { planner_ = 0; }

  virtual std::string name() const = 0;  // the device's, or "reference"

  // What is to be known of pixels that are not those of other renderers: the device, its driver, and where it rounds
  // differently (Verdict::tolerant). "" for all others.
  virtual std::string deviation() const { return ""; }

  // Bytes, about, that drawing takes besides the frame and the scene, for each pixel and whatever the size.
  struct Memory {
    std::uint64_t per_pixel = 0, fixed = 0;
  };
  virtual Memory memory() const { return {}; }

 private:
  virtual void draw(const FramePlan& plan, FrameBuffer& frame) = 0;
  std::uint64_t planner_ = 0;  // whose plans come; 0: any's
};

// Error(usage) without a session. The session must be one that Session::open() gave.
std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session);
// It draws a frame with `threads` threads, 1 to 4096, which share its rows, or with as many as can be started; 0: one for
// each processor that the process may use. The pixels are the same. Error(usage) for other numbers.
std::unique_ptr<Renderer> make_reference_renderer(int threads = 1);

}  // namespace morphcl
#pragma GCC visibility pop
