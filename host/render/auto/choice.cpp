#include "host/render/auto/choice.hpp"

#include <algorithm>
#include <cmath>

namespace morphcl {

namespace {

// What is not measured, such as the time of frames to come, may be off by so much; preparing has to pay nonetheless.
constexpr double margin = 1.15;

// A device that is ready gives a frame back for the sake of an estimate only where that is so far below what it takes.
constexpr double doubt = 4;

// Somebody waits for the first frame: a thread beside it may make it later only where it takes longer than this anyway.
constexpr double first_frame_at_once = 0.3;

// Compiling beside the reference on two processors took 1.7 times as long as alone: writing, planning and the memory
// are shared as well. The more processors there are, the less that is.
constexpr double compiling_beside = 0.7;

// Frames that come meanwhile are worth so much of the time at which the last one comes.
constexpr double worth_of_frames_meanwhile = 1.1;

double frames(const Situation& now) { return static_cast<double>(std::max<std::int64_t>(now.frames_left, 0)); }

// Storing beside the device's frames takes a processor of theirs, for as long as there are any.
double with_storing(const Situation& now, double device_frames) {
  const double drawing = device_frames * now.device_frame;
  const double threads = now.threads;
  const double beside = now.threads > 1 ? drawing * threads / (threads - 1) : 2 * drawing;
  return std::min(drawing + now.storing / threads, beside);
}

}  // namespace

double seconds_by_reference(const Situation& now) { return frames(now) * now.reference_frame; }

double seconds_by_turns(const Situation& now) {
  const double threads = now.threads;
  // On one processor each of the two has half of it.
  const double slower = now.threads > 1 ? threads / (threads - 1) : 2;
  const double reference_frame = now.reference_frame * slower;
  const double preparing = now.preparing * (now.threads > 1 ? 1 + compiling_beside / (threads - 1) : 2);
  if (reference_frame <= 0) return seconds_by_device(now);
  // The frame that is being drawn when the device is ready is finished.
  const double meanwhile = std::min(frames(now), std::max(1.0, std::ceil(preparing / reference_frame)));
  return meanwhile * reference_frame + with_storing(now, frames(now) - meanwhile);
}

double seconds_by_device(const Situation& now) { return now.preparing + with_storing(now, frames(now)); }

Choice choose(const Situation& now) {
  if (now.device == DeviceState::ready)
    return now.device_frame < now.reference_frame * (now.both_measured ? 1 : doubt) ? Choice::device
                                                                                    : Choice::reference;
  if (now.device == DeviceState::out || now.frames_left < 1) return Choice::reference;
  if (now.device == DeviceState::preparing) return Choice::reference;
  if (now.frames_drawn == 0 && now.compiles && now.reference_frame < first_frame_at_once) return Choice::reference;
  const double turns = seconds_by_turns(now), device = seconds_by_device(now);
  if (std::min(turns, device) * margin >= seconds_by_reference(now)) return Choice::reference;
  return device * worth_of_frames_meanwhile < turns ? Choice::wait : Choice::prepare;
}

}  // namespace morphcl
