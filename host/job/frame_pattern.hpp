// File names of the frames of a sequence.
#pragma once

#include <cstdint>
#include <string>

namespace morphcl {

// RenderJob::pattern, which says what a pattern may hold.
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
