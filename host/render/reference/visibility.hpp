// The reference's view of kernels/bin_primitives.cl and the first half of kernels/shade_tiles.cl: every primitive over
// every sample of every pixel of its box.
//
// A picture can be drawn in parts, as threads do: each part is some of the rows, and none needs another one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/render/frame/depth_buffer.hpp"
#include "host/render/frame/scene_vertices.hpp"

namespace morphcl::reference {

// The primitive that a sample of a pixel shows; order compares in drawing order and is no_order where nothing is seen.
struct Sample {
  float depth;        // near / distance, in parallel projections minus the distance, as the depth buffer has it
  std::uint32_t key;  // of a forward depth buffer
  std::uint64_t order;
  std::uint32_t draw, primitive;
  std::uint32_t piece;  // index into the clipped triangles of the frame, or no_piece
};
// Of blended draws: what a sample shows in front of its opaque surface.
struct Layer {
  std::size_t index;  // of the sample
  Sample surface;
};
constexpr std::uint64_t no_order = ~std::uint64_t{0};
constexpr std::uint32_t no_piece = ~std::uint32_t{0};

// A triangle that clipping left, with its corners' weights at the source triangle's vertices; or a line, of whose third
// corner all is 0.
struct Piece {
  ScreenVertex corner[3];
  float weight[3][3];
};

// Rows first, first + step, first + 2 step and so on. Neighbouring rows cost about the same, so that `step` parts with
// `first` from 0 to step - 1 do.
struct Rows {
  int first = 0, step = 1;

  int next_from(int y) const { return y <= first ? first : first + (y - first + step - 1) / step * step; }
  int count(int height) const { return height <= first ? 0 : (height - first + step - 1) / step; }
};

struct Visibility {
  Rows rows;
  int width = 0;
  int samples_a_pixel = 1;
  std::vector<Sample> samples;  // of the rows, one after the other; those of a pixel side by side. Opaque draws
  std::vector<Layer> layers;    // by sample, and from front to back: of equal depths what is drawn later comes first
  std::vector<Piece> pieces;

  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>((y - rows.first) / rows.step) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(samples_a_pixel);
  }
  const Sample& sample(int x, int y) const { return samples[index(x, y)]; }
  std::span<const Layer> layers_of(std::size_t sample) const;
  std::span<const Sample> samples_of(int x, int y) const {
    return {&samples[index(x, y)], static_cast<std::size_t>(samples_a_pixel)};
  }
};

// In front of the other, or as far, as the depth buffer has it.
inline bool is_nearer(const FramePlan& plan, const Sample& a, const Sample& b) {
  return is_forward(plan.depth_format) ? a.key > b.key : a.depth > b.depth;
}
inline bool is_as_far(const FramePlan& plan, const Sample& a, const Sample& b) {
  return is_forward(plan.depth_format) ? a.key == b.key : a.depth == b.depth;
}
// Of a blended draw, at a sample that shows this opaque surface, or the background.
inline bool is_layer_in_front(const FramePlan& plan, const Sample& blended, const Sample& opaque) {
  const bool later = opaque.order == no_order || blended.order > opaque.order;
  return is_nearer(plan, blended, opaque) || (is_as_far(plan, blended, opaque) && later);
}

// Replaces `visible`, whose memory is used again: touching as much anew for each frame takes about a fifth of its time.
void find_visible(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
                  const Rows& rows, int samples_a_pixel, Visibility& visible);

// Its parts, for other ways to find what samples show (surface_visibility.hpp). The background everywhere:
void clear(const FramePlan& plan, const Rows& rows, int samples_a_pixel, Visibility& visible);
// Blended draws in front of what is opaque, in their order:
void find_layers(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
                 Visibility& visible);
void sort_layers(const FramePlan& plan, Visibility& visible);
// Lines among what is there, opaque ones and then blended ones:
void add_lines(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
               Visibility& visible);
void add_layers_of_lines(const FramePlan& plan, const RasterGrid& grid,
                         const std::vector<std::vector<Vertex>>& vertices, Visibility& visible);

// At the centre of every pixel.
Visibility find_visible(const FramePlan& plan, const RasterGrid& grid,
                        const std::vector<std::vector<Vertex>>& vertices);

}  // namespace morphcl::reference
