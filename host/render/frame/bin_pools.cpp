#include "host/render/frame/bin_pools.hpp"

#include <algorithm>

namespace morphcl {

namespace {

using layout::uint;

uint divided_up(uint count, uint by) { return (count + by - 1) / by; }
uint with_margin(uint needed) { return needed + needed / 2; }

// Hands out room in one buffer, by cache lines.
class Offsets {
 public:
  explicit Offsets(std::size_t used) : end_(used) {}
  layout::ulong take(std::size_t bytes) {
    const std::size_t at = end_;
    constexpr std::size_t line = 64;
    end_ += (bytes + line - 1) / line * line;
    return at;
  }
  std::size_t end() const { return end_; }

 private:
  std::size_t end_;
};

void set_chunks(uint max_chunks, layout::FrameConstants& constants) {
  constexpr uint min_groups = 64;
  const uint groups = constants.primitive_group_count, wanted = std::clamp(groups / min_groups, 1u, max_chunks);
  constants.primitive_groups_per_chunk = std::max(divided_up(groups, wanted), 1u);
  constants.chunk_count = std::max(divided_up(groups, constants.primitive_groups_per_chunk), 1u);
}

BinPools with_guess(BinPools pools, const layout::FrameConstants& constants) {
  const uint primitives = constants.primitive_groups_per_chunk * layout::lanes;
  const auto tiles = static_cast<uint>(constants.tiles_x * constants.tiles_y);
  pools.fragment_pages = std::max(pools.fragment_pages, 256 + primitives / pools.primitives_a_page);
  pools.entry_pages = std::max(pools.entry_pages, 64 + tiles);
  pools.large = std::max(pools.large, 64 + primitives / 8);
  return pools;
}

BinSizes lay_out(const BinPools& pools, layout::FrameConstants& constants, std::size_t id_bytes) {
  constants.fragment_pages = pools.fragment_pages;
  constants.entry_pages = pools.entry_pages;
  constants.large_capacity = pools.large;
  constants.clip_capacity = constants.clips ? pools.clipped : 0;
  const std::size_t chunks = constants.chunk_count;
  const std::size_t tiles = static_cast<std::size_t>(constants.tiles_x) * static_cast<std::size_t>(constants.tiles_y);
  const std::size_t fragment_pages = chunks * pools.fragment_pages, entry_pages = chunks * pools.entry_pages;
  Offsets offsets(sizeof(layout::BinsHeader));
  layout::BinsOffsets& bins = constants.bins;
  // First: it stays from frame to frame, as the vertices do, and so has to stay where it is.
  bins.vertex_chunk_status = offsets.take(vertex_chunk_count(constants) * sizeof(uint));
  bins.chunk_status = offsets.take(chunks * sizeof(layout::ChunkStatus));
  bins.fragment_heads = offsets.take(chunks * tiles * sizeof(uint));
  bins.entry_heads = offsets.take(chunks * tiles * sizeof(uint));
  const std::size_t blended_tiles = constants.blends ? tiles : 0;
  bins.blended_fragment_heads = offsets.take(chunks * blended_tiles * sizeof(uint));
  bins.blended_entry_heads = offsets.take(chunks * blended_tiles * sizeof(uint));
  bins.fragment_next = offsets.take(fragment_pages * sizeof(uint));
  bins.entry_next = offsets.take(entry_pages * sizeof(uint));
  bins.entry_triangles = offsets.take(entry_pages * layout::page * sizeof(uint));
  bins.fragment_places = offsets.take(fragment_pages * layout::page * sizeof(std::uint16_t));
  bins.ids = offsets.take(id_bytes);
  return {offsets.end(), fragment_pages * layout::page * sizeof(layout::ulong),
          fragment_pages * layout::page * sizeof(layout::SampleFragment),
          chunks * pools.large * sizeof(layout::LargeTriangle),
          constants.clip_capacity * sizeof(layout::ClippedPrimitive)};
}

}  // namespace

uint vertex_chunk_count(const layout::FrameConstants& constants) {
  return divided_up(constants.vertex_group_count, layout::vertex_groups_per_chunk);
}

void BinPools::grow_to(const layout::ChunkStatus& chunk) {
  if (chunk.fragment_pages > fragment_pages) fragment_pages = with_margin(chunk.fragment_pages);
  if (chunk.entry_pages > entry_pages) entry_pages = with_margin(chunk.entry_pages);
  if (chunk.large > large) large = with_margin(chunk.large);
}

void BinPools::grow_to_clipped(uint needed) {
  if (needed > clipped) clipped = with_margin(needed);
}

BinSizes lay_out_bins(std::size_t max_allocation, BinPools& pools, layout::FrameConstants& constants,
                      std::size_t id_bytes) {
  for (uint max_chunks = 64;; max_chunks /= 2) {
    set_chunks(max_chunks, constants);
    const BinPools guessed = with_guess(pools, constants);
    const BinSizes sizes = lay_out(guessed, constants, id_bytes);
    if (sizes.bins > max_allocation && max_chunks > 1) continue;
    pools = guessed;
    return sizes;
  }
}

}  // namespace morphcl
