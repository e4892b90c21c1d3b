// What a frame has in common with those of the shot before it.
#pragma once

#include <cstdint>
#include <optional>

#include "host/render/plan.hpp"

namespace morphcl {

// Draws of `plan` that are, bit for bit, draws of the frame one earlier. 0 where there is no such frame.
std::size_t count_unchanged_draws(const Planner& planner, const FramePlan& plan);

// The latest of the shot's frames before this one that has the same picture, among the nearest 1,000.
std::optional<std::int64_t> find_equal_frame(const Planner& planner, const Scene& scene, const FramePlan& plan);

}  // namespace morphcl
