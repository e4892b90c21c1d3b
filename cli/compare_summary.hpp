// What morphcl compare says of all its frames together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/json_object.hpp"
#include "lab/frame_error/frame_difference.hpp"

namespace morphcl::cli {

// Of the frames compared with one truth.
class CompareSummary {
 public:
  explicit CompareSummary(accuracy::Truth truth) : truth_(truth) {}

  void add(const accuracy::FrameDifference& frame);

  std::string words() const;  // one line
  Json json() const;

 private:
  struct Errors {
    accuracy::Tally tally;
    std::int64_t frame = 0;  // of the largest
    void add(const accuracy::Tally& errors, std::int64_t in_frame);
  };

  accuracy::Truth truth_;
  std::vector<std::int64_t> frames_;
  bool has_color_ = false, has_depth_ = false;
  Errors color_, depth_;
  std::size_t pixels_ = 0, other_surface_ = 0;  // that show something; that show another surface, or one of them none
  std::size_t most_others_ = 0;
  std::int64_t most_others_frame_ = 0;
};

}  // namespace morphcl::cli
