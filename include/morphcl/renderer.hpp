// Renderers turn plans into pixels. Two exist: one that runs OpenCL kernels, and a reference of plain loops, slow and
// short, which defines what the kernels have to compute. They give the same bits on devices with Verdict::identical
// (session.hpp). A third one lets these two draw by turns, so that no frame waits for a compiler.
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

  virtual std::string name() const = 0;  // the device's, or "reference", or "auto"

  // The name() of the renderer that drew the last frame: another one's where this one lets others draw.
  virtual std::string drawn_by() const { return name(); }

  // So many frames are still to come, as far as is known; run() of job.hpp says so before each. It is for renderers
  // that weigh whether a preparation pays, and changes no pixel.
  virtual void expect_frames(std::int64_t /*count*/) {}

  // What is to be known of pixels that are not those of other renderers: the device, its driver, and where it rounds
  // differently (Verdict::tolerant). "" for all others.
  virtual std::string deviation() const { return ""; }

  // Bytes, about, that drawing takes besides the frame and the scene: for each pixel; for each sample where a pixel has
  // several; and whatever the size.
  struct Memory {
    std::uint64_t per_pixel = 0, fixed = 0, per_sample = 0;
  };
  virtual Memory memory() const { return {}; }

 protected:
  // For a renderer that lets another one draw the frame that it was asked for.
  static void draw_by(Renderer& other, const FramePlan& plan, FrameBuffer& frame) { other.draw(plan, frame); }

 private:
  virtual void draw(const FramePlan& plan, FrameBuffer& frame) = 0;
  std::uint64_t planner_ = 0;  // whose plans come; 0: any's
};

// Error(usage) without a session. The session must be one that Session::open() gave.
std::unique_ptr<Renderer> make_device_renderer(std::shared_ptr<Session> session);
// It draws a frame with `threads` threads, 1 to 4096, which share its rows, or with as many as can be started; 0: one
// for each processor that the process may use. The pixels are the same. Error(usage) for other numbers.
std::unique_ptr<Renderer> make_reference_renderer(int threads = 1);

struct AutoOptions {
  int threads = 0;        // of the reference and of the device: see SessionOptions
  std::string cache_dir;  // of compiled kernels: see SessionOptions
};

// A renderer that draws its first frames at once. The reference draws them, while a thread opens the default OpenCL
// device and has the kernels compiled that these frames need; then the device draws. On an empty kernel cache that
// takes PoCL 2 seconds and more, in which the reference draws dozens of small frames; where no more are wanted, nothing
// is compiled. No pixel depends on who draws: only a device with Verdict::identical takes part.
//
//   const auto renderer = make_auto_renderer({});
//   const JobResult result = run(job, scene, *renderer);  // FrameResult::drawn_by says who drew each frame
//
// Who draws the next frame follows from what was measured so far, from what the kernel cache holds, and from how many
// frames are to come, which run() says by itself; others say it with expect_frames(), else as many are assumed as were
// drawn.
//
// For one thread at a time, but for the members that say otherwise.
//
// Its destructor waits for what its own thread is at: opening the device, compiling or storing one kernel program, up
// to some 2 seconds with PoCL, which cannot be interrupted. A program that would rather end while is_preparing() leaves
// the renderer undestroyed and ends by _exit(), as destructors of the driver's globals crash its compiler. Files of the
// kernel cache are whole or absent either way.
class AutoRenderer : public Renderer {
 public:
  // "" while nothing is known against the device, else in one line why the reference draws all: no device, one that
  // rounds differently, one that failed, or too little memory for its driver. For any thread.
  virtual std::string note() const = 0;

  // The device's name once it is open, else "". For any thread.
  virtual std::string device_name() const = 0;

  // Kernels are being compiled, beside frames that the reference draws. For any thread.
  virtual bool is_compiling() const = 0;

  // The renderer's own thread is at work: it opens the device, compiles, or stores what was compiled. For any thread.
  virtual bool is_preparing() const = 0;

  // Keeps what was compiled and has drawn frames, for later processes, as Session::store_programs() does: for the end
  // of a job, which may be too short to have done this by itself. Returns at once where there is nothing to keep, and
  // where kernels are still being compiled.
  virtual void store_programs() = 0;

  // See Session::cache_trouble(). For any thread.
  virtual std::string cache_trouble() const = 0;
};

// Opens no device and starts no thread yet. Error(usage) as prepare_process() has it; what it has against the device is
// in note().
std::unique_ptr<AutoRenderer> make_auto_renderer(const AutoOptions& options);

}  // namespace morphcl
#pragma GCC visibility pop
