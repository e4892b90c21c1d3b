// Who draws the next frame, reference or device, and whether the device is got ready meanwhile: a cost model, and
// nothing but numbers in and a choice out.
//
// It compares the times at which the last frame would be done, when
//   the reference draws all of them;
//   the reference draws while a thread prepares the device (opens it, compiles kernels), which draws the others;
//   nothing is drawn until the device is ready, which draws all of them.
// Preparing takes one processor: the frames drawn meanwhile have one less, and on a single one take turns with it; and
// it takes longer beside them. So few processors may well be better left to the compiler, after the first frame.
#pragma once

#include <cstdint>

namespace morphcl {

enum class DeviceState {
  closed,     // not asked for yet, or some kernels of the frame are missing: there is something to prepare
  preparing,  // the thread is at it
  ready,      // the frame takes no compiler
  out,        // it cannot take part
};

// Times are seconds.
struct Situation {
  DeviceState device = DeviceState::closed;
  std::int64_t frames_drawn = 0;
  std::int64_t frames_left = 1;  // the next one included
  int threads = 1;               // of the reference and of the device
  double reference_frame = 0;    // by all threads; measured, but for the first frame an estimate
  double device_frame = 0;       // the same
  bool both_measured = true;     // neither of the two is an estimate
  double preparing = 0;          // opening the device, where it is not open, and what is to be compiled
  double storing = 0;            // what is compiled, kept for later processes, beside the device's frames
  bool compiles = false;         // `preparing` is more than opening the device
};

enum class Choice {
  reference,  // draws the frame
  prepare,    // the same, and the thread starts
  wait,       // the thread starts, or goes on, and the frame is the device's when it has ended
  device,     // draws the frame
};

Choice choose(const Situation& now);

// The three times, for tests and for who wants to see why.
double seconds_by_reference(const Situation& now);
double seconds_by_turns(const Situation& now);
double seconds_by_device(const Situation& now);

}  // namespace morphcl
