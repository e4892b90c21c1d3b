// What a frame has in common with those of the shot before it.
#pragma once

#include <cstdint>
#include <optional>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/planner.hpp"

namespace morphcl {

struct UnchangedDraws {
  std::int64_t frame;  // the shot's frame before
  std::size_t count;   // draws that are, bit for bit, draws of that frame
};
// Nothing where the shot has no frame before this one.
std::optional<UnchangedDraws> count_unchanged_draws(const Planner& planner, const FramePlan& plan);

// The latest of the shot's frames before this one that has the same picture, among the nearest 1,000.
std::optional<std::int64_t> find_equal_frame(const Planner& planner, const FramePlan& plan);

}  // namespace morphcl
