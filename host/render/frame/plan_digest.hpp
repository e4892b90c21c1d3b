// A number for the picture of a plan.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

// xxh3-128 over everything in a plan that decides its pixels.
struct PlanDigest {
  std::uint64_t low = 0, high = 0;
  bool operator==(const PlanDigest&) const = default;
};

// Plans of one planner with the same digest have the same pixels: size, channels, draws in their order (meshes by
// identity), lights and camera are equal bit for bit. What only says how to get there is not in it, nor are frame
// number and the matrices for the image's attributes. Of plans of different planners it says nothing.
PlanDigest pixel_digest(const FramePlan& plan);

}  // namespace morphcl

template <>
struct std::hash<morphcl::PlanDigest> {
  std::size_t operator()(const morphcl::PlanDigest& digest) const noexcept { return digest.low; }
};
