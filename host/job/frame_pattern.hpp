// File names of the frames of a sequence.
#pragma once

#include <cstdint>
#include <string>

namespace morphcl {

// A path whose file name holds at most one place for the frame number: a run of two or more '#' is that many digits, a
// lone '#' is four, %0Nd is N digits (N at most 20), %d is as many as needed. Shorter numbers get zeros in front,
// longer ones are not cut; a minus sign comes before the digits. Folders are taken as they are written.
class FramePattern {
 public:
  // Error(usage): more than one place for the number, a number's digits beyond 20, or no file name.
  explicit FramePattern(const std::string& pattern);
  std::string path(std::int64_t frame) const;  // without a place for the number: the pattern itself
  bool has_number() const { return has_number_; }
  const std::string& before_number() const { return before_; }

 private:
  std::string before_, after_;
  int digits_ = 0;
  bool has_number_ = false;
};

}  // namespace morphcl
