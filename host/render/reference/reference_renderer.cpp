#include <Imath/half.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "host/render/frame/channel_passes.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/reference/channel_writer.hpp"
#include "host/render/reference/resolve.hpp"
#include "host/render/reference/shade.hpp"
#include "host/render/reference/surface_visibility.hpp"
#include "host/thread_count.hpp"
#include "host/threads.hpp"
#include "morphcl/renderer.hpp"

namespace morphcl {

namespace {

constexpr int blended_parts = 64;

using reference::Rows;
using SceneVertices = std::vector<std::vector<reference::Vertex>>;

// Of one row of the frame; null for channels that it lacks.
struct RowMemory {
  std::uint16_t* color[4] = {};
  float* distance = nullptr;
};

std::vector<RowMemory> memory_of_rows(FrameBuffer& frame) {
  std::vector<RowMemory> rows(static_cast<std::size_t>(frame.height()));
  for (int y = 0; y < frame.height(); ++y) {
    RowMemory& row = rows[static_cast<std::size_t>(y)];
    for (int c = 0; frame.has_color() && c < 4; ++c) row.color[c] = frame.color_row(c, y).data();
    if (frame.has_depth()) row.distance = frame.depth_row(y).data();
  }
  return rows;
}

// The pixel of an opaque surface.
std::array<std::uint16_t, 4> opaque_pixel(const glm::vec3& color) {
  return {imath_float_to_half(color.r), imath_float_to_half(color.g), imath_float_to_half(color.b),
          imath_float_to_half(1.0f)};
}

std::array<std::uint16_t, 4> pixel_of_centre(const FramePlan& plan, const reference::Visibility& visible,
                                             const SceneVertices& vertices, int x, int y) {
  if (plan.blends) return reference::resolve_pixel(plan, visible, vertices, x, y);
  const reference::Sample& sample = visible.sample(x, y);
  if (sample.order != reference::no_order)
    return opaque_pixel(reference::shade_centre(plan, visible, sample, vertices, x, y).color);
  return plan.background ? (*plan.background)[static_cast<std::size_t>(y)] : BackgroundRow{};
}

// What all threads take from.
struct Picture {
  const FramePlan& plan;
  const RasterGrid& grid;
  const SceneVertices& vertices;
  const std::vector<RowMemory>& rows;
  const reference::Centres& centres;
  const reference::ChannelWriter& channels;
  const reference::SurfaceVisibility* method;  // null: the z-buffer
};

void write_shares(const Picture& picture, const reference::Visibility& visible, int x, int y) {
  if (picture.plan.blends) {
    const auto& [surfaces, coverage] = reference::shown_surfaces(picture.plan, visible, picture.vertices, x, y);
    picture.channels.write_shares(picture.plan, surfaces, coverage, x, y);
    return;
  }
  const std::span<const reference::Sample> samples = visible.samples_of(x, y);
  picture.channels.write_shares(picture.plan, samples, reference::coverage_of(samples), x, y);
}

// Of one sample a pixel, the centre. `with_color`: else what is that of the centre alone.
void draw_centres(const Picture& picture, const Rows& rows, bool with_color, reference::Visibility& visible) {
  const auto& [plan, grid, vertices, frame, centres, channels, method] = picture;
  const bool with_channels = !(plan.channels & channels_of_centres).empty(),
             with_shares = plan.samples == 1 && !(plan.channels & channels_of_samples).empty();
  if (method != nullptr)
    method->find_visible(rows, visible);
  else
    reference::find_visible(plan, grid, vertices, rows, 1, visible);
  for (int y = rows.first; y < plan.height; y += rows.step) {
    const RowMemory& row = frame[static_cast<std::size_t>(y)];
    for (int x = 0; x < plan.width; ++x) {
      if (with_color) {
        const auto pixel = pixel_of_centre(plan, visible, vertices, x, y);
        for (std::size_t c = 0; c < 4; ++c) row.color[c][x] = pixel[c];
      }
      const reference::Sample& surface = reference::surface_at_centre(plan, visible, vertices, x, y);
      if (plan.has_depth())
        row.distance[x] =
            surface.order == reference::no_order ? background_depth : reference::eye_distance(plan, surface.depth);
      if (with_channels) channels.write(centres.at(visible, surface, x, y), x, y);
      if (with_shares) write_shares(picture, visible, x, y);
    }
  }
}

// Colours, and shares of samples, of several samples a pixel.
void draw_samples(const Picture& picture, const Rows& rows, reference::Visibility& visible) {
  const auto& [plan, grid, vertices, frame, centres, channels, method] = picture;
  const bool with_shares = !(plan.channels & channels_of_samples).empty();
  reference::find_visible(plan, grid, vertices, rows, plan.samples, visible);
  for (int y = rows.first; y < plan.height; y += rows.step)
    for (int x = 0; x < plan.width; ++x) {
      if (with_shares) write_shares(picture, visible, x, y);
      if (!plan.has_color()) continue;
      const auto pixel = reference::resolve_pixel(plan, visible, vertices, x, y);
      for (std::size_t c = 0; c < 4; ++c) frame[static_cast<std::size_t>(y)].color[c][x] = pixel[c];
    }
}

void draw_rows(const Picture& picture, const Rows& rows, reference::Visibility& visible) {
  const bool one_sample = picture.plan.samples == 1;
  if (one_sample || draws_centres(picture.plan))
    draw_centres(picture, rows, picture.plan.has_color() && one_sample, visible);
  if (!one_sample) draw_samples(picture, rows, visible);
}

class ReferenceRenderer : public Renderer {
 public:
  explicit ReferenceRenderer(int threads) : threads_(threads) {}

  std::string name() const override { return "reference"; }

  // The samples of the picture.
  Memory memory() const override {
    return {.per_pixel = sizeof(reference::Sample) + 4, .fixed = 0, .per_sample = sizeof(reference::Sample)};
  }

 private:
  void draw(const FramePlan& plan, FrameBuffer& frame) override {
    const RasterGrid grid(plan.width, plan.height);
    SceneVertices vertices, next;
    for (const Draw& draw : plan.draws) vertices.push_back(reference::project_vertices(draw, plan, grid));
    for (const Draw& draw : plan.next_draws) next.push_back(reference::project_vertices(draw, plan, grid));
    const std::vector<RowMemory> rows = memory_of_rows(frame);
    const reference::Centres centres(plan, vertices, next);
    const reference::ChannelWriter channels(frame);
    std::optional<reference::SurfaceVisibility> method;
    if (plan.visibility != VisibilityMethod::z_buffer) method.emplace(plan, grid, vertices);
    const Picture picture{plan, grid, vertices, rows, centres, channels, method ? &*method : nullptr};
    const int threads = std::min(threads_, plan.height);
    // What is kept of layers is bounded by drawing few rows at a time.
    const int parts = plan.blends ? std::min(plan.height, std::max(blended_parts, threads)) : threads;
    visible_.resize(static_cast<std::size_t>(threads));
    std::mutex mutex;
    int next_part = 0;
    std::exception_ptr failure;
    const auto draw_parts = [&](int thread) {
      reference::Visibility& visible = visible_[static_cast<std::size_t>(thread)];
      for (;;) {
        int part = 0;
        {
          const std::lock_guard lock(mutex);
          if (failure || next_part == parts) return;
          part = next_part++;
        }
        try {
          draw_rows(picture, {part, parts}, visible);
        } catch (...) {
          const std::lock_guard lock(mutex);
          failure = std::current_exception();
        }
      }
    };
    {
      std::vector<std::jthread> others;
      start_threads(others, threads - 1, draw_parts);
      draw_parts(threads - 1);
    }
    if (failure) std::rethrow_exception(failure);
  }

  int threads_;
  std::vector<reference::Visibility> visible_;  // of each thread
};

}  // namespace

std::unique_ptr<Renderer> make_reference_renderer(int threads) {
  return std::make_unique<ReferenceRenderer>(choose_thread_count(threads));
}

}  // namespace morphcl
