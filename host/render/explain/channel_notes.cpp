#include "host/render/explain/channel_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/render/frame/channel_passes.hpp"

namespace morphcl {

namespace {

template <class Condition>
std::string draws_that(const FramePlan& plan, const Condition& condition) {
  const auto number = std::count_if(plan.draws.begin(), plan.draws.end(), condition);
  return fmt::format("{} of {} object{}", number, plan.draws.size(), plan.draws.size() == 1 ? "" : "s");
}

}  // namespace

std::string channel_detail(Channel channel, const FramePlan& plan) {
  const auto with_normals = [&](NormalSource source) {
    return draws_that(plan, [source](const Draw& draw) { return draw.normals == source; });
  };
  switch (channel) {
    case Channel::normal:
      return fmt::format("of vertices on {}, of faces on {}", with_normals(NormalSource::vertices),
                         with_normals(NormalSource::faces));
    case Channel::velocity:
      return draws_that(plan, [](const Draw& draw) { return draw.moves; }) + " will be elsewhere in the next frame";
    case Channel::uv:
      return draws_that(plan, [](const Draw& draw) { return !draw.mesh->uvs.empty(); }) + " with texture coordinates";
    case Channel::albedo:
      return draws_that(plan, [](const Draw& draw) { return draw.vertex_colors; }) + " with vertex colours";
    case Channel::coverage:
    case Channel::crypto_object:
    case Channel::crypto_material:
      return plan.samples == 1 ? "of the pixel's centre alone" : fmt::format("shares of {} samples", plan.samples);
    case Channel::color:
    case Channel::depth:
    case Channel::position:
    case Channel::object_id:
    case Channel::material_id:
      break;
  }
  return "";
}

std::vector<PlanNote> channel_steps(const FramePlan& plan, const FrameCosts& costs) {
  const ChannelSet of_ids = plan.channels & (channels_of_centres | channels_of_samples);
  if (of_ids.empty()) return {};
  const char* const of_what = (of_ids & channels_of_samples).empty()   ? "pixels' centres show"
                              : (of_ids & channels_of_centres).empty() ? "samples show"
                                                                       : "pixels' centres and samples show";
  const bool with_next = plan.has(Channel::velocity);
  return {{"ids of what is seen", true, fmt::format("channels beside RGBA and Z are made from what {}", of_what),
           costs.ids},
          {"next frame's vertices", with_next, with_next ? "velocity needs them" : "velocity is not asked for",
           costs.next_vertices}};
}

}  // namespace morphcl
