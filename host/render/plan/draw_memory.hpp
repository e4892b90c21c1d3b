// The draws of the frame planned before: where neither the camera nor an object's node has moved, its matrices are what
// they were.
#pragma once

#include <vector>

#include "host/render/plan.hpp"

namespace morphcl {

class DrawMemory {
 public:
  // What all draws of a frame follow from, beside their own objects.
  struct View {
    glm::dmat4 world_to_eye{0.0}, eye_to_clip{0.0};
    bool lit = false;
    bool operator==(const View&) const = default;
  };

  // Begins a frame; forgets the draws when the view is another one.
  void look(const View& view) {
    if (!(view == view_)) draws_.clear();
    view_ = view, at_ = 0, missed_ = false;
  }
  // The draw that an object had under this view, or null. Objects are asked for in ascending order.
  const Draw* find(std::uint32_t object) {
    while (at_ < draws_.size() && draws_[at_].object < object) ++at_;
    if (at_ < draws_.size() && draws_[at_].object == object) return &draws_[at_];
    missed_ = true;
    return nullptr;
  }
  // The frame's draws, to be found in the next one; those of the frame before do where none was missed.
  void remember(const std::vector<Draw>& draws) {
    if (missed_) draws_ = draws;
  }

 private:
  View view_;
  std::vector<Draw> draws_;
  std::size_t at_ = 0;
  bool missed_ = false;
};

}  // namespace morphcl
