#include "host/render/explain/earlier_frames.hpp"

#include <algorithm>

#include "host/render/frame/plan_digest.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t max_frames = 1000;

bool same_form(const Draw& a, const Draw& b) {
  const VertexAccuracy plain;
  const VertexAccuracy &of_a = a.accuracy ? *a.accuracy : plain, &of_b = b.accuracy ? *b.accuracy : plain;
  return of_a.form == of_b.form && of_a.pivot == of_b.pivot && of_a.clip_rest == of_b.clip_rest;
}

bool same_positions(const Draw& a, const Draw& b) {
  return a.displaced && b.displaced ? a.displaced->hash == b.displaced->hash : a.displaced == b.displaced;
}

bool same_vertices(const Draw& a, const Draw& b) {
  return a.mesh == b.mesh && a.object == b.object && a.shading == b.shading && a.object_to_clip == b.object_to_clip &&
         a.object_to_eye == b.object_to_eye && a.normal_to_eye == b.normal_to_eye && same_form(a, b) &&
         same_positions(a, b) && std::equal(a.targets.begin(), a.targets.end(), b.targets.begin(), b.targets.end());
}

std::vector<std::int64_t> frames_before(const Scene& scene, std::int64_t frame) {
  std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  frames.erase(std::lower_bound(frames.begin(), frames.end(), frame), frames.end());
  return frames;
}

// A frame in which the motion goes wrong has nothing in common with this one.
std::optional<Plan> try_plan(const Planner& planner, std::int64_t frame) try {
  return planner.plan(frame);
} catch (const Error&) {
  return std::nullopt;
}

}  // namespace

std::optional<UnchangedDraws> count_unchanged_draws(const Planner& planner, const FramePlan& plan) {
  const std::vector<std::int64_t> frames = frames_before(planner.scene(), plan.frame);
  if (frames.empty()) return std::nullopt;
  const std::optional<Plan> before = try_plan(planner, frames.back());
  if (!before) return std::nullopt;
  UnchangedDraws unchanged{frames.back(), 0};
  std::size_t at = 0;
  for (const Draw& draw : plan.draws) {
    while (at < (*before)->draws.size() && (*before)->draws[at].object < draw.object) ++at;
    if (at < (*before)->draws.size()) unchanged.count += same_vertices(draw, (*before)->draws[at]);
  }
  return unchanged;
}

std::optional<std::int64_t> find_equal_frame(const Planner& planner, const FramePlan& plan) {
  const std::vector<std::int64_t> frames = frames_before(planner.scene(), plan.frame);
  const PlanDigest digest = pixel_digest(plan);
  const std::size_t looked_at = std::min(frames.size(), max_frames);
  for (std::size_t i = 0; i < looked_at; ++i) {
    const std::int64_t earlier = frames[frames.size() - 1 - i];
    const std::optional<Plan> other = try_plan(planner, earlier);
    if (other && pixel_digest(**other) == digest) return earlier;
  }
  return std::nullopt;
}

}  // namespace morphcl
