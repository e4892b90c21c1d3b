#include "host/render/explain/cost_model.hpp"

#include <algorithm>
#include <cmath>

#include "host/render/frame/channel_passes.hpp"

namespace morphcl {

namespace {

bool is_of_places(Channel channel) {
  constexpr ChannelSet of_places{Channel::normal, Channel::position, Channel::velocity, Channel::uv};
  return of_places.contains(channel);
}

}  // namespace

FrameCosts estimate_costs(const FramePlan& plan, const Workload& work, const SkippedWork& skipped,
                          const CostModel& model) {
  constexpr double ms = 1e-6;  // a nanosecond
  FrameCosts costs{};
  const double written = plan.keeps_blank_tiles ? work.reached_pixels : work.pixels;
  costs.color = ms * model.byte * 8 * written;
  costs.depth = ms * model.byte * 4 * written;
  costs.blank_pixels = ms * model.byte * work.bytes_per_pixel * (work.pixels - work.reached_pixels);

  const double covered = model.covered_share * work.reached_pixels;
  // Half of n triangles show their front on p pixels, each in about the square root of twice its area rows: together
  // the square root of n p, and never more than there are pixels.
  const double spans = std::min(covered, std::sqrt(work.triangles * covered));

  costs.targets = ms * model.target_vertex * work.target_vertices;
  costs.idle_targets = ms * model.target_vertex * work.idle_target_vertices;
  costs.elastic =
      ms * (model.mode * work.modes + model.modal_pair * work.modal_pairs + model.stepped_mass * work.stepped_masses);
  costs.normals = ms * model.smooth_vertex * work.smooth_vertices;
  costs.colors = ms * (model.colored_vertex * work.colored_vertices + model.tinted_pixel * work.tinted_share * covered);
  costs.face_light = ms * model.face_light * work.flat_faces * std::max(work.lights, 1.0);
  costs.lights = ms * work.smooth_share *
                 ((model.smooth_pixel + model.pixel_light * work.lights) * covered + model.smooth_span * spans);
  costs.lines = ms * model.line * work.lines;
  costs.clipping = ms * model.clipped_vertex * work.vertices;
  costs.divide = ms * model.divided_vertex * work.vertices;
  costs.depth_test = ms * model.depth_test * covered;
  costs.depth_format = is_forward(plan.depth_format) ? ms * model.forward_pixel * covered : 0;
  costs.precise_vertices =
      ms * (model.pivot_vertex * work.pivot_vertices + model.two_float_vertex * work.two_float_vertices);

  const double vertices = ms * model.vertex * work.vertices;
  costs.vertices =
      vertices + costs.targets + costs.normals + costs.divide + ms * model.colored_vertex * work.colored_vertices;
  costs.draws = ms * (model.draw * work.draws + model.triangle * work.triangles + model.span * spans +
                      model.covered_pixel * covered) +
                vertices;
  costs.blending = ms * model.blended_pixel * work.blended_share * covered * plan.samples;
  const double of_samples =
      ms * (model.sample_triangle * work.triangles + model.sample_span * spans + model.line * work.lines);
  costs.samples = plan.samples > 1 ? of_samples * plan.samples : 0;
  costs.centres = ms * (model.triangle * work.triangles + model.span * spans + model.covered_pixel * covered);
  costs.skipped = ms * (model.vertex * skipped.vertices + model.triangle * skipped.triangles);
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto channel = static_cast<Channel>(i);
    const double planes = plane_count(channel);
    double made = channels_of_samples.contains(channel)
                      ? model.share_sample * spans * plan.samples
                      : planes * (model.plane_pixel * covered + model.plane_span * spans);
    if (is_of_places(channel)) made += model.place_pixel * covered + model.place_span * spans;
    costs.channels[i] = ms * (model.byte * static_cast<double>(pixel_bytes(channel)) * written + made);
  }
  const ChannelSet of_ids = plan.channels & (channels_of_centres | channels_of_samples);
  const double id_samples = ((of_ids & channels_of_centres).empty() || plan.samples == 1 ? 0 : 1) + plan.samples;
  costs.ids = of_ids.empty() ? 0 : ms * model.id_sample * covered * id_samples;
  costs.next_vertices = ms * model.next_vertex * work.vertices;
  double of_channels = costs.ids + (plan.has(Channel::velocity) ? costs.next_vertices : 0);
  for (const Channel channel : of_ids) of_channels += costs.channels[static_cast<std::size_t>(channel)];

  costs.everything = of_channels + ms * model.frame + costs.depth_format + costs.precise_vertices +
                     (plan.has_color() ? costs.color : 0) + (plan.has_depth() ? costs.depth : 0) + costs.draws +
                     costs.targets + costs.elastic + costs.normals + costs.colors + costs.blending + costs.face_light +
                     costs.lights + costs.lines + (plan.clips ? costs.clipping : 0) + costs.samples +
                     (plan.samples > 1 && draws_centres(plan) ? costs.centres : 0) + (plan.divides ? costs.divide : 0) +
                     (plan.tests_depth ? costs.depth_test : 0);
  return costs;
}

}  // namespace morphcl
