// The draws of the frame planned before: where neither the camera nor an object's node has moved, its matrices are what
// they were.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

class DrawMemory {
 public:
  // What all draws of a frame follow from, beside their own objects.
  struct View {
    glm::dmat4 world_to_eye{0.0}, eye_to_clip{0.0};
    bool lit = false;
    bool operator==(const View&) const = default;
  };

  // Begins a frame; forgets the draws when the view is another one. True: it is the one of the frame before.
  bool look(const View& view) {
    const bool same = view == view_;
    if (!same) draws_.clear();
    view_ = view;
    at_ = 0;
    changed_ = !same;
    return same;
  }
  // The draw that an object whose node is still had under this view, or null. Objects are asked for in ascending order.
  const Draw* find(std::uint32_t object) {
    while (at_ < draws_.size() && draws_[at_].object < object) ++at_;
    return at_ < draws_.size() && draws_[at_].object == object ? &draws_[at_] : nullptr;
  }
  // A still object that is drawn was not found, or its draw has changed.
  void replace() { changed_ = true; }
  // Takes those of the frame's draws whose node is still, to be found in the next one. Returns the frame's number for
  // FramePlan::draws_version.
  template <class IsStill>
  std::uint64_t remember(const std::vector<Draw>& draws, const IsStill& is_still) {
    const auto still = static_cast<std::size_t>(std::count_if(draws.begin(), draws.end(), is_still));
    const bool same_still = !changed_ && still == draws_.size(), all_still = still == draws.size();
    if (!same_still) {
      draws_.clear();
      std::copy_if(draws.begin(), draws.end(), std::back_inserter(draws_), is_still);
    }
    // A frame with others is like none: what moves may come, go and change.
    if (!same_still || !all_still || !all_were_still_) ++version_;
    all_were_still_ = all_still;
    return version_;
  }

 private:
  View view_;
  std::vector<Draw> draws_;
  std::size_t at_ = 0;
  bool changed_ = false;         // the view or some still draw is not what it was
  bool all_were_still_ = false;  // nothing else was drawn in the frame before
  std::uint64_t version_ = 0;
};

}  // namespace morphcl
