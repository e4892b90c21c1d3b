// The morph targets that a draw applies, in the mesh's order.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace morphcl {

struct ActiveTarget {
  int target;             // index into the mesh's targets
  float weight;           // the target's factor
  float base_weight;      // the base's factor: -weight for an absolute target, 0 for a delta
  float weight_rest = 0;  // what rounding took from the weight; of draws in two floats
  bool operator==(const ActiveTarget&) const = default;
};

// A list that holds the first few in itself: a frame of thousands of draws allocates nothing for them.
class ActiveTargets {
 public:
  void push_back(const ActiveTarget& target) {
    if (size_ < few_.size()) {
      few_[size_] = target;
    } else {
      if (size_ == few_.size()) all_.assign(few_.begin(), few_.end());
      all_.push_back(target);
    }
    ++size_;
  }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const ActiveTarget* begin() const { return size_ <= few_.size() ? few_.data() : all_.data(); }
  const ActiveTarget* end() const { return begin() + size_; }
  const ActiveTarget& operator[](std::size_t i) const { return begin()[i]; }

 private:
  std::array<ActiveTarget, 2> few_{};
  std::vector<ActiveTarget> all_;  // all of them once there are more than a few
  std::size_t size_ = 0;
};

}  // namespace morphcl
